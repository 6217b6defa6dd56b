#pragma once

#include <vectrix/kinematics/points/moving_transform.hpp>

namespace vectrix {

/// Claims that a and b have the same origin at all times, as frames of the Earth have: the rotation with r_ab
/// = 0 and v_ab|a = 0, so that a graph knows positions across it:
///     edge([=](const Epoch& t) { return coincident(teme_from_itrf(t, observed)); })
template <class A, class B, class S> Transform<A, B, S> coincident(const Dcm<A, B, S>& R_a_from_b) {
  return {R_a_from_b, coincident<B, A, A, S>(of<B>, relative_to<A>, in<A>)};
}
template <class A, class B, class S> MovingTransform<A, B, S> coincident(const MovingDcm<A, B, S>& turning) {
  return {turning, coincident<B, A, A, S>(of<B>, relative_to<A>, in<A>),
          at_rest<B, A, A, A, S>(of<B>, relative_to<A>, observed_from<A>, in<A>)};
}
/// Also a_ab|a = 0.
template <class A, class B, class S>
AcceleratingTransform<A, B, S> coincident(const AcceleratingDcm<A, B, S>& turning) {
  return {turning, coincident<B, A, A, S>(of<B>, relative_to<A>, in<A>),
          at_rest<B, A, A, A, S>(of<B>, relative_to<A>, observed_from<A>, in<A>),
          unaccelerated<B, A, A, A, S>(of<B>, relative_to<A>, observed_from<A>, in<A>)};
}

}  // namespace vectrix
