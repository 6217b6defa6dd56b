#pragma once

#include <concepts>

#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>

namespace vectrix {

/// Claims that the axes of q are parallel to those of a at all times, so that q moves and does not turn. The
/// motion of a point becomes that of a frame, an edge of a graph:
///     edge([&](const Epoch& t) { return parallel(orbit.at(t)); })
template <class A, class Q, class S>
MovingTransform<A, Q, S> parallel(const PointMotion<A, Q, A, S>& motion) {
  return {{aligned<S>(to<A>, from<Q>), at_rest<Q, A, Q, S>(of<Q>, relative_to<A>, in<Q>)},
          motion.position,
          motion.velocity};
}
/// The same with the acceleration.
template <class A, class Q, class S>
AcceleratingTransform<A, Q, S> parallel(const PointMotion<A, Q, A, S>& motion,
                                        const Acceleration<A, Q, ObservedFrom<A>, In<A>, S>& a_aq_a) {
  return {accelerating_dcm(aligned<S>(to<A>, from<Q>), at_rest<Q, A, Q, S>(of<Q>, relative_to<A>, in<Q>),
                           unaccelerated<Q, A, Q, S>(of<Q>, relative_to<A>, in<Q>)),
          motion.position, motion.velocity, a_aq_a};
}
template <class RelativeToPoint, class Q, class Observer, class S>
  requires(!std::same_as<RelativeToPoint, Observer>)
auto parallel(  // a motion of q relative to the origin of the frame that observes it
    const PointMotion<RelativeToPoint, Q, Observer, S>&) -> Refused = delete;

}  // namespace vectrix
