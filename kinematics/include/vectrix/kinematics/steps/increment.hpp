#pragma once

#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// The frame b at the start of a step, fixed in a since then. It is a type of its own, so that the frames of
/// a composition across a step cancel as in any chain.
template <Frame A, Frame B> struct Before : moving_frame {};

/// The rotation of b relative to a in a step, a rotation vector from b at the start to b at the end.
///     R_b^a(t + dt) = R_b^a(t) exp([theta]x)
template <Frame A, Frame B, class S = double> using Increment = RotationVector<Before<A, B>, B, S>;

/// Claims that the rotation is the one before a step.
template <class A, class B, class S> Dcm<A, Before<A, B>, S> before(const Dcm<A, B, S>& R_a_from_b) {
  return {detail::trusted, R_a_from_b.matrix()};
}
template <class A, class B, class S>
Quaternion<A, Before<A, B>, S> before(const Quaternion<A, B, S>& q_a_from_b) {
  return {detail::trusted, q_a_from_b.eigen()};
}

namespace detail {

// A rotation off by a small e, without its error of first order; one of order e^2 is left. Else the rounding
// of equal steps adds up.
template <class S> Square<S> nearer_rotation(const Square<S>& R) {
  const Column<S> first = R.col(0), second = R.col(1);
  const S skewed = first.dot(second) / S(2);
  const Column<S> x = (first - skewed * second) * ((S(3) - first.squaredNorm()) / S(2));
  const Column<S> y = (second - skewed * first) * ((S(3) - second.squaredNorm()) / S(2));
  Square<S> nearer;
  nearer << x, y, x.cross(y);
  return nearer;
}
template <class S> Eigen::Quaternion<S> nearer_rotation(const Eigen::Quaternion<S>& q) {
  return Eigen::Quaternion<S>(q.coeffs() * ((S(3) - q.squaredNorm()) / S(2)));
}

}  // namespace detail

template <class A, class B, class S>
Dcm<A, B, S> advanced(const Dcm<A, B, S>& R_a_from_b, const Increment<A, B, S>& theta) {
  return {detail::trusted,
          detail::nearer_rotation<S>(detail::composed(before(R_a_from_b), exp(theta)).matrix())};
}
template <class A, class B, class S>
Quaternion<A, B, S> advanced(const Quaternion<A, B, S>& q_a_from_b, const Increment<A, B, S>& theta) {
  return {detail::trusted, detail::nearer_rotation<S>((before(q_a_from_b) * exp_quaternion(theta)).eigen())};
}

namespace detail {

template <class Rotation, class Turn>
using AdvancedOf = decltype(advanced(std::declval<const Rotation&>(), std::declval<const Turn&>()));

/// Throws BadInput unless the duration of a step of b relative to a is finite.
template <class A, class B, class S> void require_duration(const S& dt, const char* action) {
  if (!all(dt - dt == S(0))) {
    throw BadInput(std::string{action} + "(of " + frame_name<B>() + " relative to " + frame_name<A>() +
                   "): dt is " + text(dt) + " s");
  }
}

/// The types for a rate of b relative to a, expressed in b; a step needs the rate in b's axes.
template <class Rate> struct BodyRate {};
template <class A, class B, class S> struct BodyRate<AngularVelocity<A, B, In<B>, S>> {
  using increment = Increment<A, B, S>;
  using dcm = Dcm<A, B, S>;
  using quaternion = Quaternion<A, B, S>;
  using scalar = S;
};

}  // namespace detail

/// The attitude after the step, for a DCM or a quaternion: advance(R_a_from_b, theta). The result is a
/// rotation for every increment, to a few rounding units after any number of steps. Throws BadInput as exp().
template <class Rotation, class Turn>
detail::AdvancedOf<Rotation, Turn> advance(const Rotation& rotation, const Turn& theta) {
  return advanced(rotation, theta);
}
template <class Rotation, class Turn>
  requires(detail::is_framed<Rotation> && !detail::Lawful<detail::AdvancedOf, Rotation, Turn>)
auto advance(  // advance(R_a_from_b, theta): the increment of the same b relative to the same a
    const Rotation&, const Turn&) -> Refused = delete;

}  // namespace vectrix
