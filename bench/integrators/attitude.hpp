#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace bench {

/// q of any norm, scalar first.
using Attitude = std::array<double, 4>;

template <class State> Attitude attitude(const State& y) {
  return {static_cast<double>(y[0]), static_cast<double>(y[1]), static_cast<double>(y[2]),
          static_cast<double>(y[3])};
}

/// The angle of conj(p) q; not a number if one of theirs is not.
inline double angle_between(const Attitude& p, const Attitude& q) {
  const double s = p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3];
  const double x = p[0] * q[1] - p[1] * q[0] - p[2] * q[3] + p[3] * q[2];
  const double y = p[0] * q[2] - p[2] * q[0] - p[3] * q[1] + p[1] * q[3];
  const double z = p[0] * q[3] - p[3] * q[0] - p[1] * q[2] + p[2] * q[1];
  return 2.0 * std::atan2(std::hypot(x, y, z), std::abs(s));
}

}  // namespace bench
