#pragma once

#include <vectrix/kinematics/screws/screw.hpp>

namespace vectrix {

// A twist can be held constant in two ways:
//     Body form:       V_ab(b)^b, at b's origin in b's axes:  X_b^a(t) = X_b^a(0) exp(V t)
//     Reference form:  V_ab(a)^a, at a's origin in a's axes:  X_b^a(t) = exp(V t) X_b^a(0)
// Six numbers held constant at another point or in other axes give a motion that is not their exponential.

/// xi_ab = V t. Claims that b coincided with a a time t ago, and that V_ab has been constant since then. Both
/// forms then give the same motion. Throws BadInput when V t is not finite.
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
Screw<A, B, S> held(const Twist<A, B, At<C>, In<C>, S>& V_ab, const Quantity<si::time, S>& t) {
  const detail::Column<S> theta = V_ab.angular_velocity().coordinates() * t.value();
  const detail::Column<S> rho = V_ab.velocity().coordinates() * t.value();
  return {detail::trusted, detail::finite_motion<Screw<A, B, S>>(theta, "held"),
          detail::finite_motion<Screw<A, B, S>>(rho, "held")};
}
template <class A, class B, class TwistAt, class TwistIn, class S, class Duration>
auto held(  // held(V_ab, t): V_ab held at b in b, or at a in a, for a time
    const Twist<A, B, TwistAt, TwistIn, S>&, const Duration&) -> Refused = delete;

/// X_b^a a time t later, for constant V_ab: X_b^a exp(V t) if V is V_ab(b)^b, exp(V t) X_b^a if it is
/// V_ab(a)^a.
/// Exact for any t, also negative. Throws BadInput when V t is not finite.
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
Transform<A, B, S> moved(const Transform<A, B, S>& X_a_from_b, const Twist<A, B, At<C>, In<C>, S>& V_ab,
                         const Quantity<si::time, S>& t) {
  // b now and b a time t later have the same type, so the increment is used as raw numbers.
  const Transform<A, B, S> increment = exp(held(V_ab, t));
  const auto composed = [](const Transform<A, B, S>& left, const Transform<A, B, S>& right) {
    return Transform<A, B, S>{
        Dcm<A, B, S>{detail::trusted, left.rotation.matrix() * right.rotation.matrix()},
        Displacement<A, B, In<A>, S>{
            detail::trusted,
            left.translation.coordinates() + left.rotation.matrix() * right.translation.coordinates()}};
  };
  if constexpr (std::same_as<C, B>) {
    return composed(X_a_from_b, increment);
  } else {
    return composed(increment, X_a_from_b);
  }
}
template <class TransformTo, class TransformFrom, class S, class Motion, class Duration>
auto moved(  // moved(X_a_from_b, V_ab, t): V_ab held at b in b, or at a in a, for a time
    const Transform<TransformTo, TransformFrom, S>&, const Motion&, const Duration&) -> Refused = delete;

}  // namespace vectrix
