#pragma once

#include <numbers>

namespace vectrix::detail {

/// An angle of [-pi, pi] counted in [0, 2 pi). One that is too little below zero to differ from a whole turn
/// is 0.
inline double in_one_turn(double angle) {
  constexpr double turn = 2.0 * std::numbers::pi;
  if (angle >= 0.0) return angle + 0.0;  // -0 becomes 0
  const double positive = angle + turn;
  return positive < turn ? positive : 0.0;
}

}  // namespace vectrix::detail
