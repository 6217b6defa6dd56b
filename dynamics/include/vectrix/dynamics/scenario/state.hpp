#pragma once

#include <optional>
#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// Position and velocity of the centre of mass, relative to the origin of i, observed from and expressed in
/// i.
template <InertialFrame I> struct OrbitState {
  Vector<I, si::length> r_i;
  Vector<I, si::velocity> v_i;
};

/// The state of a rigid body at one instant: attitude q_b^i, rate w_ib^b and, when it is carried along, the
/// orbit.
template <InertialFrame I, Frame B> struct State {
  Quantity<si::time> time;
  Quaternion<I, B> q_i_from_b;
  AngularVelocity<I, B, In<B>> w_ib_b;
  std::optional<OrbitState<I>> orbit = std::nullopt;

  Dcm<I, B> R_i_from_b() const { return dcm(q_i_from_b); }
};

}  // namespace vectrix
