#pragma once

#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>

namespace vectrix {

/// Claims that b is rigidly mounted on a: R_b^a never changes, so w_ab and alpha_ab are zero. Unlike
/// static_edge(), rates and accelerations can be asked across it.
template <class A, class B, class S>
ConstantEdge<AcceleratingDcm<A, B, S>> rigid_edge(const Dcm<A, B, S>& R_a_from_b) {
  return ConstantEdge<AcceleratingDcm<A, B, S>>{
      accelerating_dcm(R_a_from_b, at_rest<B, A, B, S>(of<B>, relative_to<A>, in<B>),
                       unaccelerated<B, A, B, S>(of<B>, relative_to<A>, in<B>))};
}
/// The same with a position: b's origin does not move in a either.
template <class A, class B, class S>
ConstantEdge<AcceleratingTransform<A, B, S>> rigid_edge(const Transform<A, B, S>& X_a_from_b) {
  return ConstantEdge<AcceleratingTransform<A, B, S>>{
      {rigid_edge(X_a_from_b.rotation).value(), X_a_from_b.translation,
       at_rest<B, A, A, A, S>(of<B>, relative_to<A>, observed_from<A>, in<A>),
       unaccelerated<B, A, A, A, S>(of<B>, relative_to<A>, observed_from<A>, in<A>)}};
}

}  // namespace vectrix
