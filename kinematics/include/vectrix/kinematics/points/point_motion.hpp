#pragma once

#include <vectrix/kinematics/points/velocity.hpp>

namespace vectrix {

/// r_pq^a and v_pq|a^a: position and velocity of the point q relative to the point p, observed from a. For an
/// orbit this is the state vector. point_motion() makes it from two vectors.
template <Point P, Point Q, Frame A, class S = double> struct PointMotion {
  Displacement<P, Q, In<A>, S> position;
  Velocity<P, Q, ObservedFrom<A>, In<A>, S> velocity;
};

/// Claims that the vectors are the position and the velocity of q relative to p, observed from a.
template <Point Q, Point P, Frame A, class S>
detail::OfTwo<P, Q, PointMotion<P, Q, A, S>> point_motion(Of<Q>, RelativeTo<P>, ObservedFrom<A>,
                                                          const Vector<A, si::length, S>& r_pq_a,
                                                          const Vector<A, si::velocity, S>& v_pq_a) {
  return PointMotion<P, Q, A, S>{displacement(of<Q>, relative_to<P>, r_pq_a),
                                 velocity(of<Q>, relative_to<P>, observed_from<A>, v_pq_a)};
}
template <class Q, class P, class A, class PositionIn, class PositionUnit, class VelocityIn,
          class VelocityUnit, class S>
auto point_motion(  // of<Q>, relative_to<P>: two points; a position and a velocity, both in a
    Of<Q>, RelativeTo<P>, ObservedFrom<A>, const Vector<PositionIn, PositionUnit, S>&,
    const Vector<VelocityIn, VelocityUnit, S>&) -> Refused = delete;

template <class P, class Q, class A, class S>
inline constexpr bool detail::is_framed<PointMotion<P, Q, A, S>> = true;

template <class P, class Q, class A, class S>
std::ostream& print_framed(std::ostream& out, const PointMotion<P, Q, A, S>& motion) {
  return out << motion.position << "; " << motion.velocity;
}

}  // namespace vectrix
