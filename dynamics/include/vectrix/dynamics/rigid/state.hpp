#pragma once

#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// The attitude q_b^i and the rate w_ib^b of a rigid body at one instant.
template <InertialFrame I, Frame B> struct State {
  Quantity<si::time> time;
  Quaternion<I, B> q_i_from_b;
  AngularVelocity<I, B, In<B>> w_ib_b;

  Dcm<I, B> R_i_from_b() const { return dcm(q_i_from_b); }
};

}  // namespace vectrix
