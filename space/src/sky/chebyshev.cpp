#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <vectrix/space/sky/chebyshev.hpp>

namespace vectrix::detail {
namespace {

constexpr double grid_day = 2451544.5;  // 2000 January 1, TAI
constexpr double seconds_of_day = 86400.0;

}  // namespace

ChebyshevPieces::ChebyshevPieces(Series series, int piece_days, int coefficients, const Epoch& first,
                                 const Epoch& last)

    : piece_days_(piece_days),
      pieces_per_day_(1.0 / piece_days),
      rows_of_piece_(coefficients + coefficients % 2) {
  const auto piece_of = [&](const Epoch& epoch) {
    return std::floor((epoch.tai().day - grid_day) / piece_days);
  };
  first_day_ = grid_day + piece_of(first) * piece_days;
  pieces_ = static_cast<int>(piece_of(last) - piece_of(first)) + 1;
  const int order = coefficients - 1;
  std::vector<Eigen::Vector3d> nodes(static_cast<std::size_t>(coefficients));
  rows_.reserve(static_cast<std::size_t>(pieces_) * static_cast<std::size_t>(rows_of_piece_));
  for (int piece = 0; piece < pieces_; ++piece) {
    for (int i = 0; i < coefficients; ++i) {
      const double u = std::cos(std::numbers::pi * i / order);
      const auto epoch =
          Epoch::from_julian_date(scale::tai, first_day_ + piece * piece_days, 0.5 * piece_days * (1.0 + u));
      nodes[static_cast<std::size_t>(i)] = series(epoch.tt_date()).position;
    }
    // c_j = 2/n sum_i f(u_i) cos(pi i j / n), where the first and the last term of each sum count half.
    for (int j = 0; j < coefficients; ++j) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (int i = 0; i < coefficients; ++i) {
        const double weight = i == 0 || i == order ? 0.5 : 1.0;
        sum += weight * std::cos(std::numbers::pi * (i * j % (2 * order)) / order) *
               nodes[static_cast<std::size_t>(i)];
      }
      const double weight = j == 0 || j == order ? 1.0 : 2.0;
      rows_.emplace_back((Row() << weight / order * sum, 0.0).finished());
    }
    if (coefficients % 2 == 1) rows_.emplace_back(Row::Zero());
  }
}

PlainMotion ChebyshevPieces::at(const JulianDate<scale::Tai>& tai) const {
  const double days = tai.day - first_day_;  // a whole number
  const auto piece = std::clamp(static_cast<int>((days + 0.5) * pieces_per_day_), 0, pieces_ - 1);
  const double u = 2.0 * ((days - piece * piece_days_) + tai.fraction) * pieces_per_day_ - 1.0;
  // Two polynomials at once: T_{j+2} = 2 T_2 T_j - T_{j-2} with T_{-1} = T_1 and T_{-2} = T_2, and the
  // derivative of that.
  const double twice_t2 = 4.0 * u * u - 2.0;
  const double twice_slope2 = 8.0 * u;
  Eigen::Array2d t_before(0.5 * twice_t2, u);
  Eigen::Array2d slope_before(0.5 * twice_slope2, 1.0);
  Eigen::Array2d t(1.0, u);
  Eigen::Array2d slope(0.0, 1.0);
  Row r = Row::Zero();
  Row drdu = Row::Zero();
  const Row* c = &rows_[static_cast<std::size_t>(piece) * static_cast<std::size_t>(rows_of_piece_)];
  for (const Row* const end = c + rows_of_piece_; c != end; c += 2) {
    r += t[0] * c[0] + t[1] * c[1];
    drdu += slope[0] * c[0] + slope[1] * c[1];
    const Eigen::Array2d t_next = twice_t2 * t - t_before;
    const Eigen::Array2d slope_next = twice_t2 * slope + twice_slope2 * t - slope_before;
    t_before = t;
    slope_before = slope;
    t = t_next;
    slope = slope_next;
  }
  return {r.head<3>(), 2.0 / seconds_of_day * pieces_per_day_ * drdu.head<3>()};
}

}  // namespace vectrix::detail
