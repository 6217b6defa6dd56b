#pragma once

#include <Eigen/Core>
#include <ostream>
#include <string>
#include <vector>
#include <vectrix/dynamics/multibody/tree.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix {

using multibody::HubMotion;

/// Joints of a body b on its parent p, with the numbers of each in the order of a state. Places are counted
/// from R_0 = `R_p_from_b` and r_0 = `r_pb_p`; an effort has the unit of power over speed.
///              positions                                    speeds
///     hinge    angle about an axis fixed in both, rad       its rate, rad/s
///     slider   length along an axis fixed in both, m        its rate, m/s
///     gimbal   angles about an axis fixed in p, then about  their rates, rad/s
///              one fixed in b, rad
///     ball     q of R_0^-1 R_b^p, scalar first              w_pb^b, rad/s
///     free     q as that of a ball, then r_pb^p - r_0, m    w_pb^b, rad/s, then v_pb|p^p, m/s
///     fixed    none                                         none
enum class JointKind { hinge, slider, gimbal, ball, free, fixed };

/// A body b in plain numbers, in SI units. `r_bc_b` is its centre of mass from its origin, `J_c_b` its
/// inertia tensor about the centre, in its axes; `R_p_from_b` and `r_pb_p` say where it is on its parent when
/// the joint's numbers are zero. The origin of b lies on its joint.
struct PlainBody {
  std::string name, parent;
  JointKind joint;
  std::vector<Eigen::Vector3d> axes_b;  ///< unit vectors: one of a hinge or slider, two of a gimbal
  Eigen::Matrix3d R_p_from_b;
  Eigen::Vector3d r_pb_p;
  double mass;
  Eigen::Vector3d r_bc_b;
  Eigen::Matrix3d J_c_b;
};

/// A balanced rotor inside a body, which contains its mass; its inertia about its axis, kg m^2.
struct PlainRotor {
  std::string name, body;
  Eigen::Vector3d axis_b;
  double inertia;
};

/// A mode of a flexible appendage, of mass 1, so that its coordinate has the unit kg^1/2 m: its participation
/// in rotation about the body's origin, kg^1/2 m, and in translation, kg^1/2, its frequency, rad/s.
struct PlainMode {
  std::string name, body;
  Eigen::Vector3d rotation_b, translation_b;
  double frequency, damping_ratio;
};

/// A spacecraft in names and plain numbers: what a file holds, and what another program takes. The hub's
/// attitude and position are relative to the frame `inertial`. Bodies may stand in any order.
struct PlainSpacecraft {
  std::string inertial, hub;
  HubMotion motion;
  double mass;
  Eigen::Vector3d r_hc_h;
  Eigen::Matrix3d J_c_h;
  std::vector<PlainBody> bodies;
  std::vector<PlainRotor> rotors;
  std::vector<PlainMode> modes;
};

/// One line for each part.
VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const PlainSpacecraft& craft);

}  // namespace vectrix
