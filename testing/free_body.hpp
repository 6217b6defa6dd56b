#pragma once

#include <array>
#include <span>

namespace vectrix_test {

/// A rigid body without torque, in its principal axes, in numbers alone: q_i_from_b, scalar first, and w_ib_b
/// in y. J are the principal moments.
///     d/dt q = 1/2 q (0, w),   J d/dt w = -w x J w
inline void free_body(const std::array<double, 3>& J, std::span<const double, 7> y,
                      std::span<double, 7> ydot) {
  const double wx = y[4], wy = y[5], wz = y[6];
  ydot[0] = 0.5 * (-y[1] * wx - y[2] * wy - y[3] * wz);
  ydot[1] = 0.5 * (y[0] * wx + y[2] * wz - y[3] * wy);
  ydot[2] = 0.5 * (y[0] * wy + y[3] * wx - y[1] * wz);
  ydot[3] = 0.5 * (y[0] * wz + y[1] * wy - y[2] * wx);
  ydot[4] = (J[1] - J[2]) / J[0] * (wy * wz);
  ydot[5] = (J[2] - J[0]) / J[1] * (wz * wx);
  ydot[6] = (J[0] - J[1]) / J[2] * (wx * wy);
}

}  // namespace vectrix_test
