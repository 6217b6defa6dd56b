#include "row_spline.hpp"

#include <cstddef>

namespace vectrix::detail {
namespace {

using Five = Eigen::Matrix<double, 5, 1>;  // of x, y, UT1-TAI, dX, dY

Five values(const EarthOrientationParameters& row) {
  return (Five() << row.pole_x.value(), row.pole_y.value(), row.ut1_minus_tai.value(), row.dX.value(),
          row.dY.value())
      .finished();
}
Five rates(const EarthOrientationParameters& row) {
  return (Five() << row.pole_x_rate.value(), row.pole_y_rate.value(), row.ut1_gain.value(),
          row.dX_rate.value(), row.dY_rate.value())
      .finished();
}

}  // namespace

// With steps h_i and mean slopes d_i = (f_{i+1} - f_i) / h_i the slopes m_i satisfy
//     h_i m_{i-1} + 2 (h_{i-1} + h_i) m_i + h_{i-1} m_{i+1} = 3 (h_i d_{i-1} + h_{i-1} d_i)
// and, where the first two cubics are one,
//     h_1 m_0 + (h_0 + h_1) m_1 = ((3 h_0 + 2 h_1) h_1 d_0 + h_0^2 d_1) / (h_0 + h_1)
// and at the end the same in reverse. Solved by elimination from the first row to the last.
void set_rates(const std::vector<Epoch>& epochs, std::vector<EarthOrientationParameters>& rows) {
  const std::size_t n = rows.size();
  std::vector<double> h(n - 1), above(n);
  std::vector<Five> d(n - 1), m(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = (epochs[i + 1] - epochs[i]).value();
    d[i] = (values(rows[i + 1]) - values(rows[i])) / h[i];
  }
  const auto end_slopes = [](double h0, double h1, const Five& d0, const Five& d1) -> Five {
    return ((3.0 * h0 + 2.0 * h1) * h1 * d0 + h0 * h0 * d1) / (h0 + h1);
  };
  above[0] = (h[0] + h[1]) / h[1];
  m[0] = end_slopes(h[0], h[1], d[0], d[1]) / h[1];
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 2.0 * (h[i - 1] + h[i]) - h[i] * above[i - 1];
    above[i] = h[i - 1] / pivot;
    m[i] = (3.0 * (h[i] * d[i - 1] + h[i - 1] * d[i]) - h[i] * m[i - 1]) / pivot;
  }
  const double left = h[n - 2] + h[n - 3];
  m[n - 1] = (end_slopes(h[n - 2], h[n - 3], d[n - 2], d[n - 3]) - left * m[n - 2]) /
             (h[n - 3] - left * above[n - 2]);
  for (std::size_t i = n - 1; i-- > 0;) m[i] -= above[i] * m[i + 1];
  for (std::size_t i = 0; i < n; ++i) {
    const auto rate = [&](Eigen::Index k) { return m[i][k] * (si::radian / si::second); };
    rows[i].pole_x_rate = rate(0);
    rows[i].pole_y_rate = rate(1);
    rows[i].ut1_gain = Quantity<si::dimensionless>{m[i][2]};
    rows[i].dX_rate = rate(3);
    rows[i].dY_rate = rate(4);
  }
}

Eigen::Matrix<double, 5, 3> cubic(const EarthOrientationParameters& left,
                                  const EarthOrientationParameters& right, const Quantity<si::time>& day,
                                  const Quantity<si::time>& after_left) {
  const double h = day.value();
  const double u = after_left.value() / h;
  const Five f = values(left), c1 = h * rates(left), moved = values(right) - f;
  const Five c2 = 3.0 * moved - 2.0 * c1 - h * rates(right);
  const Five c3 = c1 + h * rates(right) - 2.0 * moved;
  Eigen::Matrix<double, 5, 3> found;
  found.col(0) = f + u * (c1 + u * (c2 + u * c3));
  found.col(1) = (c1 + u * (2.0 * c2 + 3.0 * u * c3)) / h;
  found.col(2) = (2.0 * c2 + 6.0 * u * c3) / (h * h);
  return found;
}

}  // namespace vectrix::detail
