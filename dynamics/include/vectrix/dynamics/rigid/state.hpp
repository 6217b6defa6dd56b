#pragma once

#include <optional>
#include <vectrix/dynamics/force/about.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// The state of a rigid body at one instant: attitude q_b^i, rate w_ib^b and, optionally, the orbit of its
/// centre of mass c, r_ic^i and v_ic|i^i.
template <InertialFrame I, Frame B> struct State {
  Quantity<si::time> time;
  Quaternion<I, B> q_i_from_b;
  AngularVelocity<I, B, In<B>> w_ib_b;
  std::optional<PointMotion<I, CentreOfMassOf<B>, I>> orbit = std::nullopt;

  Dcm<I, B> R_i_from_b() const { return dcm(q_i_from_b); }
};

}  // namespace vectrix
