#pragma once

#include <vectrix/kinematics/screws/screw.hpp>

namespace vectrix {
namespace detail {

/// [J 0; Q J], where J is J_l(theta) and Q is its derivative along rho. By the principle of transference
/// SE(3) has the dual number theta + s rho, s^2 = 0, where SO(3) has the number theta.
template <class S> Eigen::Matrix<S, 6, 6> left_jacobian(const Turn<S>& turn, const Column<S>& rho) {
  Eigen::Matrix<S, 6, 6> matrix = Eigen::Matrix<S, 6, 6>::Zero();
  const Square<S> J = matrix_of<S>([&](const auto& x) { return left_jacobian_times(turn, x); });
  matrix.template topLeftCorner<3, 3>() = J;
  matrix.template bottomRightCorner<3, 3>() = J;
  matrix.template bottomLeftCorner<3, 3>() =
      matrix_of<S>([&](const auto& x) { return left_jacobian_change_times(turn, rho, x); });
  return matrix;
}
/// [J^-1 0; -J^-1 Q J^-1 J^-1]
template <class S> Eigen::Matrix<S, 6, 6> inverse_left_jacobian(const Turn<S>& turn, const Column<S>& rho) {
  Eigen::Matrix<S, 6, 6> matrix = Eigen::Matrix<S, 6, 6>::Zero();
  const Square<S> inverse = matrix_of<S>([&](const auto& x) { return inverse_left_jacobian_times(turn, x); });
  matrix.template topLeftCorner<3, 3>() = inverse;
  matrix.template bottomRightCorner<3, 3>() = inverse;
  matrix.template bottomLeftCorner<3, 3>() = matrix_of<S>([&](const auto& x) {
    const Column<S> change = left_jacobian_change_times(turn, rho, inverse_left_jacobian_times(turn, x));
    return Column<S>(-inverse_left_jacobian_times(turn, change));
  });
  return matrix;
}

/// theta or rho for the Jacobian in the frame c: the left one in a, the right one in b, J_r(xi) = J_l(-xi).
template <class C, class A, class B, class S> Column<S> rotation_in(const Screw<A, B, S>& xi_ab) {
  const Column<S>& theta = xi_ab.rotation_vector().coordinates();
  return std::same_as<C, A> ? theta : Column<S>(-theta);
}
template <class C, class A, class B, class S> Column<S> translation_in(const Screw<A, B, S>& xi_ab) {
  const Column<S> rho = xi_ab.in_reference().coordinates();
  return std::same_as<C, A> ? rho : Column<S>(-rho);
}

}  // namespace detail

/// ad(xi), a bare 6x6 matrix, rotation first: exp(ad(xi)) = Ad(exp(xi)).
template <class A, class B, class S> Eigen::Matrix<S, 6, 6> ad(const Screw<A, B, S>& xi_ab) {
  return detail::ad<S>(detail::rotation_in<A>(xi_ab), detail::translation_in<A>(xi_ab));
}

/// The left Jacobian of SE(3), I + ad(xi)/2! + ad(xi)^2/3! + ..., a bare 6x6 matrix, rotation first:
/// V_ab(a)^a = J_l(xi_ab) xi_dot. In closed form, accurate to rounding for every angle (its lower left block
/// is the Q of Barfoot and Furgale 2014). Throws BadInput where |theta|^2 overflows.
template <class A, class B, class S> Eigen::Matrix<S, 6, 6> left_jacobian(const Screw<A, B, S>& xi_ab) {
  const auto turn = detail::turn<Screw<A, B, S>>(detail::rotation_in<A>(xi_ab), "left_jacobian");
  return detail::left_jacobian(turn, detail::translation_in<A>(xi_ab));
}
/// J_r(xi) = J_l(-xi) = Ad(exp(-xi)) J_l(xi): V_ab(b)^b = J_r(xi_ab) xi_dot.
template <class A, class B, class S> Eigen::Matrix<S, 6, 6> right_jacobian(const Screw<A, B, S>& xi_ab) {
  const auto turn = detail::turn<Screw<A, B, S>>(detail::rotation_in<B>(xi_ab), "right_jacobian");
  return detail::left_jacobian(turn, detail::translation_in<B>(xi_ab));
}
/// The inverses. Throw BadInput with the distance at a full turn, as the inverses of SO(3).
template <class A, class B, class S>
Eigen::Matrix<S, 6, 6> inverse_left_jacobian(const Screw<A, B, S>& xi_ab) {
  const auto turn =
      detail::invertible_turn<Screw<A, B, S>>(detail::rotation_in<A>(xi_ab), "inverse_left_jacobian");
  return detail::inverse_left_jacobian(turn, detail::translation_in<A>(xi_ab));
}
template <class A, class B, class S>
Eigen::Matrix<S, 6, 6> inverse_right_jacobian(const Screw<A, B, S>& xi_ab) {
  const auto turn =
      detail::invertible_turn<Screw<A, B, S>>(detail::rotation_in<B>(xi_ab), "inverse_right_jacobian");
  return detail::inverse_left_jacobian(turn, detail::translation_in<B>(xi_ab));
}

}  // namespace vectrix
