#pragma once

#include <vectrix/kinematics/rotation_vector_rate.hpp>
#include <vectrix/kinematics/screw.hpp>

namespace vectrix {
namespace detail {

/// [J 0; Q J], J being J_l(theta) and Q its change along rho: where SO(3) has the number theta, SE(3) has the
/// dual number theta + s rho, s^2 = 0 (the principle of transference).
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

template <class A, class B, class S> Column<S> translation_of(const Screw<A, B, S>& xi_ab) {
  return xi_ab.in_reference().coordinates();
}

}  // namespace detail

/// ad(xi), the bare six by six numbers, rotation first: exp(ad(xi)) = Ad(exp(xi)).
template <class A, class B, class S> Eigen::Matrix<S, 6, 6> ad(const Screw<A, B, S>& xi_ab) {
  return detail::ad<S>(xi_ab.rotation_vector().coordinates(), detail::translation_of(xi_ab));
}

/// The left Jacobian of SE(3), I + ad(xi)/2! + ad(xi)^2/3! + ..., the bare six by six numbers, rotation
/// first: V_ab(a)^a = J_l(xi_ab) xi_dot. In closed form, accurate to rounding for every angle (its lower left
/// block is the Q of Barfoot and Furgale 2014). Throws BadInput where |theta|^2 overflows.
template <class A, class B, class S> Eigen::Matrix<S, 6, 6> left_jacobian(const Screw<A, B, S>& xi_ab) {
  return detail::left_jacobian(detail::turn(xi_ab.rotation_vector(), "left_jacobian(screw"),
                               detail::translation_of(xi_ab));
}
/// J_r(xi) = J_l(-xi) = Ad(exp(-xi)) J_l(xi): V_ab(b)^b = J_r(xi_ab) xi_dot.
template <class A, class B, class S> Eigen::Matrix<S, 6, 6> right_jacobian(const Screw<A, B, S>& xi_ab) {
  return detail::left_jacobian(
      detail::jacobian_in<B, A>(detail::turn(xi_ab.rotation_vector(), "right_jacobian(screw")),
      detail::jacobian_in<B, A>(detail::translation_of(xi_ab)));
}
/// Throw BadInput, and say how near, where |theta| is at a full turn, as those of SO(3).
template <class A, class B, class S>
Eigen::Matrix<S, 6, 6> inverse_left_jacobian(const Screw<A, B, S>& xi_ab) {
  return detail::inverse_left_jacobian(
      detail::invertible_turn(xi_ab.rotation_vector(), "inverse_left_jacobian(screw"),
      detail::translation_of(xi_ab));
}
template <class A, class B, class S>
Eigen::Matrix<S, 6, 6> inverse_right_jacobian(const Screw<A, B, S>& xi_ab) {
  return detail::inverse_left_jacobian(detail::jacobian_in<B, A>(detail::invertible_turn(
                                           xi_ab.rotation_vector(), "inverse_right_jacobian(screw")),
                                       detail::jacobian_in<B, A>(detail::translation_of(xi_ab)));
}

/// xi_dot = (theta_dot, rho_dot), the time derivative of xi_ab, rad/s and m/s: no twist, unless the axis
/// rests.
///     V_ab(b)^b = J_r(xi_ab) xi_dot,  V_ab(a)^a = J_l(xi_ab) xi_dot
template <Frame A, Frame B, class S = double> class ScrewRate {
 public:
  template <class Rotation, class Translation>
  ScrewRate(detail::Trusted, const Eigen::MatrixBase<Rotation>& theta_dot,
            const Eigen::MatrixBase<Translation>& rho_dot)
      : thetadot_(detail::trusted, theta_dot), rhodot_(rho_dot) {}

  const RotationVectorRate<A, B, S>& rotation_vector_rate() const& { return thetadot_; }
  RotationVectorRate<A, B, S> rotation_vector_rate() && { return thetadot_; }
  /// rho_dot expressed in a or in b.
  Vector<A, si::velocity, S> in_reference() const { return {detail::trusted, rhodot_}; }
  Vector<B, si::velocity, S> in_turned() const { return {detail::trusted, rhodot_}; }
  Eigen::Matrix<S, 6, 1> coordinates() const {
    Eigen::Matrix<S, 6, 1> numbers;
    numbers << thetadot_.coordinates(), rhodot_;
    return numbers;
  }
  /// The derivative of xi_ba = -xi_ab.
  ScrewRate<B, A, S> operator-() const { return {detail::trusted, -thetadot_.coordinates(), -rhodot_}; }

 private:
  RotationVectorRate<A, B, S> thetadot_;
  detail::Column<S> rhodot_;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<ScrewRate<A, B, S>> = true;

/// Claims that the two are the derivative of xi_ab, both expressed in a or both in b.
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
detail::OfTwo<B, A, ScrewRate<A, B, S>> screw_rate(Of<B>, RelativeTo<A>,
                                                   const Vector<C, si::angular_velocity, S>& theta_dot,
                                                   const Vector<C, si::velocity, S>& rho_dot) {
  return {detail::trusted, theta_dot.coordinates(), rho_dot.coordinates()};
}
template <class OfFrame, class RelativeToFrame, class Rotation, class Translation>
auto screw_rate(  // of<B>, relative_to<A>: two frames; rad/s and m/s expressed in one of them
    const OfFrame&, const RelativeToFrame&, const Rotation&, const Translation&) -> Refused = delete;

/// V_ab(b)^b = J_r(xi_ab) xi_dot in<B>, V_ab(a)^a = J_l(xi_ab) xi_dot in<A>. Throws as left_jacobian().
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
Twist<A, B, At<C>, In<C>, S> twist(const Screw<A, B, S>& xi_ab, const ScrewRate<A, B, S>& xidot_ab, In<C>) {
  const auto turn = detail::jacobian_in<C, A>(detail::turn(xi_ab.rotation_vector(), "twist(screw"));
  const detail::Column<S> theta_dot = xidot_ab.rotation_vector_rate().coordinates();
  const detail::Column<S> change = detail::jacobian_in<C, A>(detail::translation_of(xi_ab));
  return {detail::trusted, detail::left_jacobian_times(turn, theta_dot),
          detail::left_jacobian_change_times(turn, change, theta_dot) +
              detail::left_jacobian_times(turn, xidot_ab.in_reference().coordinates())};
}
template <class A, class B, class S, class Rate, class Expressed>
auto twist(  // twist(xi_ab, xidot_ab, in<B>) or in<A>
    const Screw<A, B, S>&, const Rate&, const Expressed&) -> Refused = delete;

// xi_dot = J_r^-1 V_ab(b)^b = J_l^-1 V_ab(a)^a, by rate(xi_ab, V_ab). Throws BadInput at a full turn.
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
ScrewRate<A, B, S> attitude_rate(const Screw<A, B, S>& xi_ab, const Twist<A, B, At<C>, In<C>, S>& V_ab) {
  const auto turn = detail::jacobian_in<C, A>(detail::invertible_turn(xi_ab.rotation_vector(), "rate(screw"));
  const detail::Column<S> change = detail::jacobian_in<C, A>(detail::translation_of(xi_ab));
  const detail::Column<S> theta_dot =
      detail::inverse_left_jacobian_times(turn, V_ab.angular_velocity().coordinates());
  const detail::Column<S> rest =
      V_ab.velocity().coordinates() - detail::left_jacobian_change_times(turn, change, theta_dot);
  return {detail::trusted, theta_dot, detail::inverse_left_jacobian_times(turn, rest)};
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const ScrewRate<A, B, S>& xidot_ab) {
  const auto xidot = xidot_ab.coordinates();
  detail::print_column(out << "d/dt ", xidot.template head<3>(), "rad/s") << "; ";
  return detail::print_column(out, xidot.template tail<3>(), "m/s") << detail::print_of_relative_to<B, A>;
}

}  // namespace vectrix
