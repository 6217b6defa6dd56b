#pragma once

#include <limits>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/kinematics/samples/instant.hpp>

namespace vectrix {

/// Position and velocity at the time t after the sample `start`; `end` is a time h after `start`. The
/// position is the cubic with the positions and velocities of both samples (Hermite), the velocity its
/// derivative. With s = t/h:
///     r = r0 + s^2 (3 - 2s) (r1 - r0) + s (1 - s) h ((1 - s) v0 - s v1)
/// In the middle its error is h^4/384 times the fourth derivative of r. Throws BadInput when h is not
/// positive and finite, h is so short that a velocity overflows, or t is outside [0, h].
template <class P, class Q, class A, class S>
PointMotion<P, Q, A, S> hermite(const PointMotion<P, Q, A, S>& start, const PointMotion<P, Q, A, S>& end,
                                const Quantity<si::time, std::type_identity_t<S>>& h,
                                const Quantity<si::time, std::type_identity_t<S>>& t) {
  using detail::Column, detail::instant_text;
  // 3/(2 h), the largest factor of the velocity, is finite.
  const S least(std::numeric_limits<decltype(detail::without_derivatives(h.value()))>::min());
  const S s = t.value() / h.value();
  if (!(h.value() >= least && h.value() - h.value() == S(0) && s >= S(0) && s <= S(1))) {
    if (h.value() > S(0) && h.value() < least)
      throw BadInput("hermite in " + frame_name<A>() + ": the duration is " + instant_text(h) +
                     "; the velocity overflows");
    throw BadInput("hermite in " + frame_name<A>() + ": the time " + instant_text(t) + " is outside [0 s, " +
                   instant_text(h) + "]");
  }
  const Column<S>&r0 = start.position.coordinates(), &v0 = start.velocity.coordinates();
  const Column<S>&r1 = end.position.coordinates(), &v1 = end.velocity.coordinates();
  const S one(1), two(2), three(3), six(6);
  const Column<S> step = r1 - r0;
  const Column<S> r =
      r0 + s * s * (three - two * s) * step + s * (one - s) * h.value() * ((one - s) * v0 - s * v1);
  const Column<S> v = six * s * (one - s) / h.value() * step + (one - s) * (one - three * s) * v0 +
                      s * (three * s - two) * v1;
  return {Displacement<P, Q, In<A>, S>{detail::trusted, r},
          Velocity<P, Q, ObservedFrom<A>, In<A>, S>{detail::trusted, v}};
}

}  // namespace vectrix
