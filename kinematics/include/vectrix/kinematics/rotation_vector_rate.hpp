#pragma once

#include <vectrix/kinematics/angular_acceleration.hpp>
#include <vectrix/kinematics/dcm_rate.hpp>
#include <vectrix/kinematics/jacobian.hpp>

namespace vectrix {
namespace detail {

/// The first or the second derivative of a rotation vector theta_ab; as this is, the same numbers in a and in
/// b.
template <Frame A, Frame B, VectorUnit U, class S> class TurnDerivative {
 public:
  template <class Derived>
  TurnDerivative(Trusted, const Eigen::MatrixBase<Derived>& coordinates) : coordinates_(coordinates) {}

  const Column<S>& coordinates() const& { return coordinates_; }
  Column<S> coordinates() && { return coordinates_; }
  Vector<A, U, S> in_reference() const { return {trusted, coordinates_}; }
  Vector<B, U, S> in_turned() const { return {trusted, coordinates_}; }

 private:
  Column<S> coordinates_;
};

}  // namespace detail

/// theta_dot, the time derivative of theta_ab, rad/s: no angular velocity, unless the axis rests. Its law
/// (Bortz 1971 has the inverse):
///     w_ab^b = J_r(theta_ab) theta_dot,  w_ab^a = J_l(theta_ab) theta_dot
template <Frame A, Frame B, class S = double>
class RotationVectorRate : public detail::TurnDerivative<A, B, si::angular_velocity, S> {
 public:
  using detail::TurnDerivative<A, B, si::angular_velocity, S>::TurnDerivative;

  /// The derivative of theta_ba = -theta_ab.
  RotationVectorRate<B, A, S> operator-() const { return {detail::trusted, -this->coordinates()}; }
};
/// theta_ddot, the second derivative of theta_ab, rad/s^2:
///     alpha_ab^b = J_r theta_ddot + dJ_r/dt theta_dot,  alpha_ab^a = J_l theta_ddot + dJ_l/dt theta_dot
template <Frame A, Frame B, class S = double>
class RotationVectorAcceleration : public detail::TurnDerivative<A, B, si::angular_acceleration, S> {
 public:
  using detail::TurnDerivative<A, B, si::angular_acceleration, S>::TurnDerivative;

  RotationVectorAcceleration<B, A, S> operator-() const { return {detail::trusted, -this->coordinates()}; }
};

template <class A, class B, class S>
inline constexpr bool detail::is_framed<RotationVectorRate<A, B, S>> = true;
template <class A, class B, class S>
inline constexpr bool detail::is_framed<RotationVectorAcceleration<A, B, S>> = true;

/// Claims that the vector, expressed in a or in b, is the derivative of theta_ab; and the second.
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
detail::OfTwo<B, A, RotationVectorRate<A, B, S>> rotation_vector_rate(
    Of<B>, RelativeTo<A>, const Vector<C, si::angular_velocity, S>& theta_dot) {
  return {detail::trusted, theta_dot.coordinates()};
}
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
detail::OfTwo<B, A, RotationVectorAcceleration<A, B, S>> rotation_vector_acceleration(
    Of<B>, RelativeTo<A>, const Vector<C, si::angular_acceleration, S>& theta_ddot) {
  return {detail::trusted, theta_ddot.coordinates()};
}
template <class OfFrame, class RelativeToFrame, class Given>
auto rotation_vector_rate(  // of<B>, relative_to<A>: two frames; a vector in rad/s in one of them
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;
template <class OfFrame, class RelativeToFrame, class Given>
auto rotation_vector_acceleration(  // of<B>, relative_to<A>: two frames; in rad/s^2, in one of them
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

namespace detail {

/// dJ/dt theta_dot; the right Jacobian is the left one of a vector that changes by -theta_dot.
template <class C, class A, class B, class S>
Column<S> changing_jacobian_times(const Turn<S>& turn, const RotationVectorRate<A, B, S>& thetadot_ab) {
  const Column<S>& x = thetadot_ab.coordinates();
  return left_jacobian_change_times(turn, jacobian_in<C, A>(x), x);
}

}  // namespace detail

/// w_ab^b = J_r(theta_ab) theta_dot in<B>, w_ab^a = J_l(theta_ab) theta_dot in<A>.
/// Accurate to rounding for every angle. Throws BadInput where |theta|^2 overflows.
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
AngularVelocity<A, B, In<C>, S> angular_velocity(const RotationVector<A, B, S>& theta_ab,
                                                 const RotationVectorRate<A, B, S>& thetadot_ab, In<C>) {
  const auto turn = detail::jacobian_in<C, A>(detail::turn(theta_ab, "angular_velocity(rotation vector"));
  return AngularVelocity<A, B, In<C>, S>{detail::trusted,
                                         detail::left_jacobian_times(turn, thetadot_ab.coordinates())};
}
/// alpha_ab^c = J theta_ddot + dJ/dt theta_dot, with J_r in<B> and J_l in<A>. Throws as angular_velocity().
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
AngularAcceleration<A, B, In<C>, S> angular_acceleration(
    const RotationVector<A, B, S>& theta_ab, const RotationVectorRate<A, B, S>& thetadot_ab,
    const RotationVectorAcceleration<A, B, S>& thetaddot_ab, In<C>) {
  const auto turn = detail::jacobian_in<C, A>(detail::turn(theta_ab, "angular_acceleration(rotation vector"));
  return AngularAcceleration<A, B, In<C>, S>{detail::trusted,
                                             detail::left_jacobian_times(turn, thetaddot_ab.coordinates()) +
                                                 detail::changing_jacobian_times<C>(turn, thetadot_ab)};
}
template <class A, class B, class S, class Rate, class Expressed>
auto angular_velocity(  // angular_velocity(theta_ab, thetadot_ab, in<B>) or in<A>
    const RotationVector<A, B, S>&, const Rate&, const Expressed&) -> Refused = delete;
template <class A, class B, class S, class Rate, class Change, class Expressed>
auto angular_acceleration(  // angular_acceleration(theta_ab, thetadot_ab, thetaddot_ab, in<B>) or in<A>
    const RotationVector<A, B, S>&, const Rate&, const Change&, const Expressed&) -> Refused = delete;

// theta_dot = J_r^-1 w_ab^b = J_l^-1 w_ab^a, by rate(theta_ab, w_ab_b). Throws BadInput at a full turn.
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
RotationVectorRate<A, B, S> attitude_rate(const RotationVector<A, B, S>& theta_ab,
                                          const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  const auto turn = detail::jacobian_in<C, A>(detail::invertible_turn(theta_ab, "rate(rotation vector"));
  return {detail::trusted, detail::inverse_left_jacobian_times(turn, w_ab_c.coordinates())};
}

/// theta_ddot = J^-1 (alpha_ab^c - dJ/dt theta_dot), theta_dot = J^-1 w_ab^c, with J_r in b and J_l in a.
/// Throws BadInput at a full turn, as inverse_left_jacobian().
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
RotationVectorAcceleration<A, B, S> second_rate(const RotationVector<A, B, S>& theta_ab,
                                                const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                                const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  const auto turn =
      detail::jacobian_in<C, A>(detail::invertible_turn(theta_ab, "second_rate(rotation vector"));
  const RotationVectorRate<A, B, S> thetadot_ab{
      detail::trusted, detail::inverse_left_jacobian_times(turn, w_ab_c.coordinates())};
  const detail::Column<S> rest =
      alpha_ab_c.coordinates() - detail::changing_jacobian_times<C>(turn, thetadot_ab);
  return {detail::trusted, detail::inverse_left_jacobian_times(turn, rest)};
}
template <class A, class B, class S, class Rate, class Change>
auto second_rate(  // second_rate(theta_ab, w_ab_c, alpha_ab_c): c is a or b
    const RotationVector<A, B, S>&, const Rate&, const Change&) -> Refused = delete;

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const RotationVectorRate<A, B, S>& thetadot_ab) {
  return detail::print_column(out << "d/dt ", thetadot_ab.coordinates(), "rad/s")
         << detail::print_of_relative_to<B, A>;
}
template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const RotationVectorAcceleration<A, B, S>& thetaddot_ab) {
  return detail::print_column(out << "d2/dt2 ", thetaddot_ab.coordinates(), "rad/s^2")
         << detail::print_of_relative_to<B, A>;
}

}  // namespace vectrix
