#pragma once

#include <numbers>
#include <vectrix/frames/scalar/stumpff.hpp>
#include <vectrix/kinematics/attitude/parameters.hpp>
#include <vectrix/kinematics/attitude/rotation_vector.hpp>

namespace vectrix {
namespace detail {

/// theta, and Stumpff's functions of |theta|^2, from which its Jacobians are computed.
template <class S> struct Turn {
  Column<S> theta;
  Stumpff<S> c;
};
template <class X, class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_square(const S& square, const char* action) {
  throw BadInput(parameters_name<X>(action) + "|theta|^2 is " + text(square));
}
/// X is a rotation vector or a screw. Throws BadInput where |theta|^2 overflows.
template <class X, class S> Turn<S> turn(const Column<S>& theta, const char* action) {
  const S square = theta.squaredNorm();
  if (!all(square - square == S(0))) refuse_square<X>(square, action);
  return {theta, stumpff(square)};
}
/// For the right Jacobian, J_r(theta) = J_l(-theta).
template <class S> Turn<S> right_turn(const Column<S>& theta) {
  return {Column<S>(-theta), stumpff<S>(theta.squaredNorm())};
}
/// J_l x = x + c_2 theta x x + c_3 theta x (theta x x), without the matrix.
template <class S> Column<S> left_jacobian_times(const Turn<S>& turn, const Column<S>& x) {
  const Column<S> cross = turn.theta.cross(x);
  return x + turn.c.c2 * cross + turn.c.c3 * turn.theta.cross(cross);
}
/// J_l^-1 x = x - 1/2 theta x x + e theta x (theta x x), e = -d_2/(2 c_2).
template <class S> Column<S> inverse_left_jacobian_times(const Turn<S>& turn, const Column<S>& x) {
  const Column<S> cross = turn.theta.cross(x);
  const S e = -turn.c.d2 / (S(2) * turn.c.c2);
  return x - cross / S(2) + e * turn.theta.cross(cross);
}
/// d/ds J_l(theta + s rho) x at s = 0; dc_2/ds and dc_3/ds by the derivatives of Stumpff's functions.
template <class S>
Column<S> left_jacobian_change_times(const Turn<S>& turn, const Column<S>& rho, const Column<S>& x) {
  const auto& [theta, c] = turn;
  const Column<S> cross = theta.cross(x);
  const S along = theta.dot(rho);
  return c.c2 * rho.cross(x) + c.c3 * (theta.cross(rho.cross(x)) + rho.cross(cross)) +
         along * (c.d2 * cross + c.d3 * theta.cross(cross));
}

/// The matrix of the linear map x -> f(x).
template <class S, class Function> Square<S> matrix_of(const Function& f) {
  Square<S> matrix;
  matrix << f(Column<S>(Column<S>::UnitX())), f(Column<S>(Column<S>::UnitY())),
      f(Column<S>(Column<S>::UnitZ()));
  return matrix;
}

/// As turn(), for J^-1. Throws BadInput when |theta| is within rounding of a non-zero whole number of turns.
template <class X, class S> Turn<S> invertible_turn(const Column<S>& theta, const char* action) {
  const Turn<S> result = turn<X>(theta, action);
  // 2 c_2 = (2 sin(|theta|/2) / |theta|)^2; near a full turn that is the relative distance from it, squared.
  const S limit = singular_angle<S>() / number<S>(2 * std::numbers::pi);
  if (const S relative = S(2) * result.c.c2; !all(relative > limit * limit)) {
    using std::sqrt;
    const auto square = without_derivatives(S(relative * theta.squaredNorm()));
    refuse_singular<X>(decltype(square + square)(sqrt(square)), action);
  }
  return result;
}

}  // namespace detail

/// The left Jacobian of SO(3), a bare 3x3 matrix:
///     J_l = I + (1 - cos t)/t^2 [theta]x + (t - sin t)/t^3 ([theta]x)^2,    t = |theta|
/// w_ab^a = J_l(theta_ab) theta_dot, and r_ab^a = J_l(theta_ab) rho of exp(screw). Accurate to rounding for
/// every angle. Throws BadInput where |theta|^2 overflows.
template <class A, class B, class S>
detail::Square<S> left_jacobian(const RotationVector<A, B, S>& theta_ab) {
  const auto turn = detail::turn<RotationVector<A, B, S>>(theta_ab.coordinates(), "left_jacobian");
  return detail::matrix_of<S>([&](const auto& x) { return detail::left_jacobian_times(turn, x); });
}
/// The right Jacobian, J_r(theta) = J_l(-theta) = J_l(theta)^T: w_ab^b = J_r(theta_ab) theta_dot.
template <class A, class B, class S>
detail::Square<S> right_jacobian(const RotationVector<A, B, S>& theta_ab) {
  const auto turn =
      detail::turn<RotationVector<A, B, S>>(detail::Column<S>(-theta_ab.coordinates()), "right_jacobian");
  return detail::matrix_of<S>([&](const auto& x) { return detail::left_jacobian_times(turn, x); });
}
/// J_l^-1 = I - 1/2 [theta]x + (1 - t/2 cot t/2)/t^2 ([theta]x)^2. It loses digits near a full turn, where
/// the Jacobian is singular. Throws BadInput with the distance when no digit is correct.
template <class A, class B, class S>
detail::Square<S> inverse_left_jacobian(const RotationVector<A, B, S>& theta_ab) {
  using X = RotationVector<A, B, S>;
  const auto turn = detail::invertible_turn<X>(theta_ab.coordinates(), "inverse_left_jacobian");
  return detail::matrix_of<S>([&](const auto& x) { return detail::inverse_left_jacobian_times(turn, x); });
}
/// J_r^-1(theta) = J_l^-1(-theta). Throws as inverse_left_jacobian().
template <class A, class B, class S>
detail::Square<S> inverse_right_jacobian(const RotationVector<A, B, S>& theta_ab) {
  using X = RotationVector<A, B, S>;
  const auto turn =
      detail::invertible_turn<X>(detail::Column<S>(-theta_ab.coordinates()), "inverse_right_jacobian");
  return detail::matrix_of<S>([&](const auto& x) { return detail::inverse_left_jacobian_times(turn, x); });
}

namespace detail {

/// J is the right Jacobian for a rate expressed in b, the left one for a rate in a (the first in Bortz 1971):
///     theta' = J^-1 w        theta'' = J^-1 (alpha - J' theta')
/// theta' and theta'' are singular at a full turn; w and alpha from them are not.
template <class A, class B, class S, bool expressed_in_turned>
struct KinematicsOf<RotationVector<A, B, S>, expressed_in_turned> {
  using Parameters = RotationVector<A, B, S>;

  static Column<S> rate(const Parameters& x, const Column<S>& w) {
    return inverse_left_jacobian_times(invertible_turn<Parameters>(of_jacobian(x.coordinates()), "rate"), w);
  }
  static Column<S> velocity(const Parameters& x, const Column<S>& rate) {
    return left_jacobian_times(turn<Parameters>(of_jacobian(x.coordinates()), "angular_velocity"), rate);
  }
  static Column<S> second_rate(const Parameters& x, const Column<S>& rate, const Column<S>&,
                               const Column<S>& alpha) {
    const auto turn = invertible_turn<Parameters>(of_jacobian(x.coordinates()), "second_rate");
    return inverse_left_jacobian_times<S>(
        turn, alpha - left_jacobian_change_times<S>(turn, of_jacobian(rate), rate));
  }
  static Column<S> acceleration(const Parameters& x, const Column<S>& rate, const Column<S>& second) {
    const auto turn = detail::turn<Parameters>(of_jacobian(x.coordinates()), "angular_acceleration");
    return left_jacobian_times(turn, second) + left_jacobian_change_times<S>(turn, of_jacobian(rate), rate);
  }

 private:
  // J_r(theta) = J_l(-theta); the rate of its argument is -theta'.
  static Column<S> of_jacobian(const Column<S>& x) { return expressed_in_turned ? Column<S>(-x) : x; }
};

}  // namespace detail
}  // namespace vectrix
