#pragma once

#include <vectrix/kinematics/hat.hpp>
#include <vectrix/kinematics/rotation_vector.hpp>
#include <vectrix/kinematics/stumpff.hpp>

namespace vectrix {
namespace detail {

/// theta with what its Jacobians take: Stumpff's functions of |theta|^2.
template <class S> struct Turn {
  Column<S> theta;
  Stumpff<S> c;
};
template <class A, class B, class S>
Turn<S> turn(const RotationVector<A, B, S>& theta_ab, const char* action) {
  return {theta_ab.coordinates(), stumpff(checked_square(theta_ab, action))};
}
/// What belongs to the Jacobian in a frame c: in a that is the left one, in b the right one, J_r(theta) =
/// J_l(-theta).
template <class C, class A, class S> Turn<S> jacobian_in(const Turn<S>& turn) {
  return {std::same_as<C, A> ? turn.theta : Column<S>(-turn.theta), turn.c};
}
template <class C, class A, class S> Column<S> jacobian_in(const Column<S>& change) {
  return std::same_as<C, A> ? change : Column<S>(-change);
}

/// J_l x = x + c_2 theta x x + c_3 theta x (theta x x), without the matrix.
template <class S> Column<S> left_jacobian_times(const Turn<S>& turn, const Column<S>& x) {
  const Column<S> cross = turn.theta.cross(x);
  return x + turn.c.c2 * cross + turn.c.c3 * turn.theta.cross(cross);
}
/// J_l^-1 x = x - 1/2 theta x x + e theta x (theta x x), e = (c_3 - 2 c_4)/(2 c_2).
template <class S> Column<S> inverse_left_jacobian_times(const Turn<S>& turn, const Column<S>& x) {
  const Column<S> cross = turn.theta.cross(x);
  const S e = (turn.c.c3 - S(2) * turn.c.c4) / (S(2) * turn.c.c2);
  return x - cross / S(2) + e * turn.theta.cross(cross);
}
/// d/ds J_l(theta + s rho) x at s = 0; dc_2/ds and dc_3/ds by the derivatives of Stumpff's functions.
template <class S>
Column<S> left_jacobian_change_times(const Turn<S>& turn, const Column<S>& rho, const Column<S>& x) {
  const auto& [theta, c] = turn;
  const Column<S> cross = theta.cross(x);
  const S along = theta.dot(rho);
  return c.c2 * rho.cross(x) + c.c3 * (theta.cross(rho.cross(x)) + rho.cross(cross)) +
         along * ((S(2) * c.c4 - c.c3) * cross + (S(3) * c.c5 - c.c4) * theta.cross(cross));
}

/// The matrix of x -> f(x).
template <class S, class Function> Square<S> matrix_of(const Function& f) {
  Square<S> matrix;
  matrix << f(Column<S>(Column<S>::UnitX())), f(Column<S>(Column<S>::UnitY())),
      f(Column<S>(Column<S>::UnitZ()));
  return matrix;
}

template <class B, class A, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_full_turn(const char* action, const S& angle,
                                                             const S& distance) {
  throw BadInput(about_turn<B, A>(action) + "|theta| is " + text(angle) + ", within " + text(distance) +
                 " of a full turn, where no inverse exists");
}
/// |theta| may be no nearer to a full turn, two, ... than its own rounding: there no digit is left.
template <class A, class B, class S>
Turn<S> invertible_turn(const RotationVector<A, B, S>& theta_ab, const char* action) {
  const Turn<S> result = turn(theta_ab, action);
  // 2 c_2 = (2 sin(|theta|/2) / |theta|)^2; near a full turn that is the relative distance from it, squared.
  const S limit = S(4) * S(Eigen::NumTraits<S>::epsilon());
  if (const S relative = S(2) * result.c.c2; !all(relative > limit * limit)) {
    using std::sqrt;
    const S angle = sqrt(theta_ab.coordinates().squaredNorm());
    refuse_full_turn<B, A>(action, angle, S(sqrt(relative) * angle));
  }
  return result;
}

}  // namespace detail

/// The left Jacobian of SO(3), three by three bare numbers:
///     J_l = I + (1 - cos t)/t^2 [theta]x + (t - sin t)/t^3 ([theta]x)^2,    t = |theta|
/// w_ab^a = J_l(theta_ab) theta_dot, and r_ab^a = J_l(theta_ab) rho of exp(screw). Accurate to rounding for
/// every angle. Throws BadInput where |theta|^2 overflows.
template <class A, class B, class S>
detail::Square<S> left_jacobian(const RotationVector<A, B, S>& theta_ab) {
  const auto turn = detail::turn(theta_ab, "left_jacobian(rotation vector");
  return detail::matrix_of<S>([&](const auto& x) { return detail::left_jacobian_times(turn, x); });
}
/// The right Jacobian, J_r(theta) = J_l(-theta) = J_l(theta)^T: w_ab^b = J_r(theta_ab) theta_dot.
template <class A, class B, class S>
detail::Square<S> right_jacobian(const RotationVector<A, B, S>& theta_ab) {
  const auto turn = detail::jacobian_in<B, A>(detail::turn(theta_ab, "right_jacobian(rotation vector"));
  return detail::matrix_of<S>([&](const auto& x) { return detail::left_jacobian_times(turn, x); });
}
/// J_l^-1 = I - 1/2 [theta]x + (1 - t/2 cot t/2)/t^2 ([theta]x)^2. Its digits get lost as |theta| comes near
/// to a full turn, where the Jacobian is singular: throws BadInput, and says how near, when none is left.
template <class A, class B, class S>
detail::Square<S> inverse_left_jacobian(const RotationVector<A, B, S>& theta_ab) {
  const auto turn = detail::invertible_turn(theta_ab, "inverse_left_jacobian(rotation vector");
  return detail::matrix_of<S>([&](const auto& x) { return detail::inverse_left_jacobian_times(turn, x); });
}
/// J_r^-1(theta) = J_l^-1(-theta). Throws as inverse_left_jacobian().
template <class A, class B, class S>
detail::Square<S> inverse_right_jacobian(const RotationVector<A, B, S>& theta_ab) {
  const auto turn =
      detail::jacobian_in<B, A>(detail::invertible_turn(theta_ab, "inverse_right_jacobian(rotation vector"));
  return detail::matrix_of<S>([&](const auto& x) { return detail::inverse_left_jacobian_times(turn, x); });
}

}  // namespace vectrix
