#pragma once

#include <vectrix/frames/edge.hpp>
#include <vectrix/kinematics/moving_dcm.hpp>

namespace vectrix {

/// Claims that b is rigidly mounted on a: R_b^a never changes, so w_ab and alpha_ab are zero. Unlike
/// static_edge(), whose motion is not known, rates and accelerations can be asked across it.
template <class A, class B, class S>
ConstantEdge<AcceleratingDcm<A, B, S>> rigid_edge(const Dcm<A, B, S>& R_a_from_b) {
  return ConstantEdge<AcceleratingDcm<A, B, S>>{
      accelerating_dcm(R_a_from_b, at_rest<B, A, B, S>(of<B>, relative_to<A>, in<B>),
                       unaccelerated<B, A, B, S>(of<B>, relative_to<A>, in<B>))};
}

}  // namespace vectrix
