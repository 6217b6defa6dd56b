#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <vector>

#include <vectrix/space/sky/chebyshev.hpp>

#include "../fused.hpp"

namespace vectrix::detail {
namespace {

constexpr double grid_day = 2451544.5;  // 2000 January 1, TAI
constexpr double seconds_of_day = 86400.0;

using Points = std::vector<Eigen::Vector3d>;

// The coefficients of the Chebyshev series through values at u_i = cos(pi i / n), i = 0 to n:
//     c_j = 2/n sum_i f(u_i) cos(pi i j / n), where the first and the last term of each sum count half.
Points chebyshev_series(const Points& values) {
  const int order = static_cast<int>(values.size()) - 1;
  Points series;
  for (int j = 0; j <= order; ++j) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i <= order; ++i) {
      const double weight = i == 0 || i == order ? 0.5 : 1.0;
      sum += weight * std::cos(std::numbers::pi * (i * j % (2 * order)) / order) *
             values[static_cast<std::size_t>(i)];
    }
    const double weight = j == 0 || j == order ? 1.0 : 2.0;
    series.emplace_back(weight / order * sum);
  }
  return series;
}

// The same in powers of u. No digit is lost: the terms of a motion over a piece decrease as those of its
// Taylor series, faster than the powers of T_j grow.
Points power_series(const Points& chebyshev) {
  const std::size_t size = chebyshev.size();
  Points powers(size, Eigen::Vector3d::Zero());
  std::vector<double> before(size, 0.0), now(size, 0.0);  // T_{j-1} and T_j in powers of u
  now[0] = 1.0;
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = 0; k < size; ++k) powers[k] += now[k] * chebyshev[j];
    std::vector<double> next(size, 0.0);  // T_{j+1} = 2 u T_j - T_{j-1}, and T_1 = u T_0
    for (std::size_t k = 0; k < size; ++k)
      next[k] = (k > 0 ? (j > 0 ? 2.0 : 1.0) * now[k - 1] : 0.0) - before[k];
    before = now;
    now = next;
  }
  return powers;
}

using Pair = double __attribute__((vector_size(16)));
struct Value {
  Pair xy{}, z{};
};
struct Sum {
  Value value, slope;
};

// value + slope x, and the same of the next coefficient.
[[gnu::always_inline]] inline void add(Sum& sum, const Pair& x, const std::array<double, 4>& row) {
  Value c;
  std::memcpy(&c.xy, row.data(), sizeof c.xy);
  std::memcpy(&c.z, row.data() + 2, sizeof c.z);
  sum.slope.xy = sum.slope.xy * x + sum.value.xy;
  sum.slope.z = sum.slope.z * x + sum.value.z;
  sum.value.xy = sum.value.xy * x + c.xy;
  sum.value.z = sum.value.z * x + c.z;
}

// The odd and the even powers by themselves, r = E(u^2) + u O(u^2), so that neither waits for the other, and
// dr/du = O + 2u (dE + u dO).
[[gnu::always_inline]] inline Sum sum_of(const std::array<double, 4>* row, int count, double u) {
  const Pair x{u * u, u * u}, by{u, u}, twice{2.0 * u, 2.0 * u};
  Sum odd, even;
  for (const auto* const end = row + count; row != end; row += 2) {
    add(odd, x, row[0]);
    add(even, x, row[1]);
  }
  return {{even.value.xy + by * odd.value.xy, even.value.z + by * odd.value.z},
          {odd.value.xy + twice * (even.slope.xy + by * odd.slope.xy),
           odd.value.z + twice * (even.slope.z + by * odd.slope.z)}};
}
Sum sum_at(const std::array<double, 4>* row, int count, double u) {
  return fused([&]() __attribute__((always_inline)) { return sum_of(row, count, u); });
}

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
  rows_.reserve(static_cast<std::size_t>(pieces_) * static_cast<std::size_t>(rows_of_piece_));
  for (int piece = 0; piece < pieces_; ++piece) {
    Points values;
    for (int i = 0; i < coefficients; ++i) {
      const double u = std::cos(std::numbers::pi * i / (coefficients - 1));
      const auto epoch =
          Epoch::from_julian_date(scale::tai, first_day_ + piece * piece_days, 0.5 * piece_days * (1.0 + u));
      values.push_back(series(epoch.tt_date()).position);
    }
    Points powers = power_series(chebyshev_series(values));
    powers.resize(static_cast<std::size_t>(rows_of_piece_), Eigen::Vector3d::Zero());
    for (auto a = powers.rbegin(); a != powers.rend(); ++a) rows_.push_back({a->x(), a->y(), a->z(), 0.0});
  }
}

PlainMotion ChebyshevPieces::at(const JulianDate<scale::Tai>& tai) const {
  const double days = tai.day - first_day_;  // a whole number
  const auto piece = std::clamp(static_cast<int>((days + 0.5) * pieces_per_day_), 0, pieces_ - 1);
  const double u = 2.0 * ((days - piece * piece_days_) + tai.fraction) * pieces_per_day_ - 1.0;
  const auto [r, drdu] = sum_at(
      &rows_[static_cast<std::size_t>(piece) * static_cast<std::size_t>(rows_of_piece_)], rows_of_piece_, u);
  const double per_second = 2.0 / seconds_of_day * pieces_per_day_;
  return {{r.xy[0], r.xy[1], r.z[0]},
          {per_second * drdu.xy[0], per_second * drdu.xy[1], per_second * drdu.z[0]}};
}

}  // namespace vectrix::detail
