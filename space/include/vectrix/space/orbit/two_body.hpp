#pragma once

#include <string>
#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/points/derivative.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/orbit/attraction.hpp>

namespace vectrix {

/// A propagated motion and its derivatives by the initial one: rows r and v then, columns r and v at the
/// start, SI units,
///     d(r(t), v(t)) = matrix d(r(0), v(0))
template <Point P, Point Q, Frame A> struct TwoBodyTransition {
  PointMotion<P, Q, A> motion;
  Eigen::Matrix<double, 6, 6> matrix;
};

namespace detail {

/// The result of a law that holds for an inertial observer only.
template <class A, class Result> using IfInertial = std::enable_if_t<InertialFrame<A>, Result>;

using StateTransition = Eigen::Matrix<double, 6, 6>;
template <class P, class Q> Caller orbit_of(const char* action) {
  return {action, [] { return frame_name<Q>() + " relative to " + frame_name<P>(); }};
}

struct OrbitNumbers {
  Eigen::Vector3d r, v;
};
/// The motion after dt, and if asked its derivatives.
VECTRIX_EXPORT OrbitNumbers propagated(const Caller& name, double mu, const OrbitNumbers& start, double dt,
                                       StateTransition* transition);

template <class P, class Q, class A> PointMotion<P, Q, A> point_motion_of(const OrbitNumbers& orbit) {
  return {Displacement<P, Q, In<A>>{trusted, orbit.r},
          Velocity<P, Q, ObservedFrom<A>, In<A>>{trusted, orbit.v}};
}
template <class P, class Q, class A> OrbitNumbers numbers_of(const PointMotion<P, Q, A>& motion) {
  return {motion.position.coordinates(), motion.velocity.coordinates()};
}
}  // namespace detail

/// The motion of q relative to p after dt, of either sign, if they attract each other as points, mu the sum
/// of both parameters: an ellipse, parabola, hyperbola or line. Universal variables, dt = r s + (r . v) G_2 +
/// (mu - beta r) G_3 with beta = 2 mu/r - v^2 (Battin, section 4.5), and
///     r(t) = f r + g v,  f = 1 - mu G_2/r,  g = r G_1 + (r . v) G_2
/// The error is about what the rounding of mu, r, v and dt may cause. Throws BadInput if mu is not positive
/// and finite, dt not finite or so long that its rounding is more than a revolution, q at p, or the motion
/// after dt is not finite.
template <class P, class Q, class A>
detail::IfInertial<A, PointMotion<P, Q, A>> two_body(const Quantity<si::gravitational_parameter>& mu,
                                                     const PointMotion<P, Q, A>& motion,
                                                     const Quantity<si::time>& dt) {
  return detail::point_motion_of<P, Q, A>(detail::propagated(
      detail::orbit_of<P, Q>("two_body"), mu.value(), detail::numbers_of(motion), dt.value(), nullptr));
}
template <class Motion>
auto two_body(  // mu in m^3/s^2, a PointMotion observed from an inertial frame, dt in s
    const Quantity<si::gravitational_parameter>&, const Motion&, const Quantity<si::time>&)
    -> Refused = delete;

/// The same with the state transition matrix.
template <class P, class Q, class A>
detail::IfInertial<A, TwoBodyTransition<P, Q, A>> two_body_transition(
    const Quantity<si::gravitational_parameter>& mu, const PointMotion<P, Q, A>& motion,
    const Quantity<si::time>& dt) {
  detail::StateTransition matrix;
  const auto end = detail::propagated(detail::orbit_of<P, Q>("two_body_transition"), mu.value(),
                                      detail::numbers_of(motion), dt.value(), &matrix);
  return {detail::point_motion_of<P, Q, A>(end), matrix};
}
template <class Motion>
auto two_body_transition(  // mu in m^3/s^2, a PointMotion observed from an inertial frame, dt in s
    const Quantity<si::gravitational_parameter>&, const Motion&, const Quantity<si::time>&)
    -> Refused = delete;

/// a = -mu r/|r|^3, and its derivative -mu (v - 3 (r . v) r/|r|^2)/|r|^3: what lvlh() and the other orbit
/// frames take. Throws BadInput if mu is not positive or mu/|r|^3 is not finite.
template <class P, class Q, class A, class S>
detail::IfInertial<A, Acceleration<P, Q, ObservedFrom<A>, In<A>, S>> two_body_acceleration(
    const Quantity<si::gravitational_parameter, S>& mu, const Displacement<P, Q, In<A>, S>& r_pq_a) {
  const S pull = detail::attraction<S>(detail::orbit_of<P, Q>("two_body_acceleration"), mu.value(),
                                       norm(r_pq_a).value());
  return Acceleration<P, Q, ObservedFrom<A>, In<A>, S>{detail::trusted, -pull * r_pq_a.coordinates()};
}
template <class P, class Q, class A, class S>
detail::IfInertial<A, Derivative<A, A, si::acceleration, S>> two_body_jerk(
    const Quantity<si::gravitational_parameter, S>& mu, const PointMotion<P, Q, A, S>& motion) {
  const detail::Column<S>&r = motion.position.coordinates(), &v = motion.velocity.coordinates();
  const S distance = norm(motion.position).value();
  const S pull = detail::attraction<S>(detail::orbit_of<P, Q>("two_body_jerk"), mu.value(), distance);
  const S along = S(3) * r.dot(v) / (distance * distance);
  return {detail::trusted, Vector<A, si::jerk, S>{detail::trusted, pull * (along * r - v)}};
}
template <class Mu, class Position>
auto two_body_acceleration(  // mu in m^3/s^2; r relative to the centre, in an inertial frame
    const Mu&, const Position&) -> Refused = delete;
template <class Mu, class Motion>
auto two_body_jerk(  // mu in m^3/s^2; a PointMotion observed from an inertial frame
    const Mu&, const Motion&) -> Refused = delete;

}  // namespace vectrix
