#pragma once

#include <vectrix/kinematics/attitude/jacobian.hpp>

namespace vectrix::detail {

/// theta(t) and its derivatives, where q_b^a = q_0 exp(theta) with a constant q_0.
template <class S> struct LogMotion {
  Column<S> theta, rate, acceleration;

  /// w_ab^b = J_r theta'
  Column<S> angular_velocity() const { return left_jacobian_times(right_turn(theta), rate); }
  /// alpha_ab^b = J_r theta'' + J_r' theta'
  Column<S> angular_acceleration() const {
    const Turn<S> turn = right_turn(theta);
    return left_jacobian_times(turn, acceleration) +
           left_jacobian_change_times<S>(turn, Column<S>(-rate), rate);
  }
};

/// J_r of theta, and its inverse for |theta| < 2 pi.
template <class S> Square<S> log_jacobian(const Column<S>& theta) {
  const Turn<S> turn = right_turn(theta);
  return matrix_of<S>([&](const auto& x) { return left_jacobian_times(turn, x); });
}
template <class S> Square<S> inverse_log_jacobian(const Column<S>& theta) {
  const Turn<S> turn = right_turn(theta);
  return matrix_of<S>([&](const auto& x) { return inverse_left_jacobian_times(turn, x); });
}

}  // namespace vectrix::detail
