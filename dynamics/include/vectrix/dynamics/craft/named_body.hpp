#pragma once

#include <string>
#include <vector>
#include <vectrix/dynamics/craft/joint.hpp>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/mass/mass_properties.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix {

/// The frames of a body that has its name at run time, and of the body on which it hangs. They keep the
/// numbers of the two apart.
struct ThisBody : moving_frame {};
struct ParentBody : moving_frame {};

/// A joint of the body on its parent: hinge(), slider(), gimbal(), ball(), free_joint() or fixed_joint() with
/// these two frames.
struct NamedJoint {
  template <JointKind joint>
  NamedJoint(const BodyJoint<joint, ParentBody, ThisBody>& given)
      : kind(joint), X_p_from_b(given.X_p_from_b), axes_b(given.axes_b) {}

  JointKind kind;
  Transform<ParentBody, ThisBody> X_p_from_b;
  std::vector<Eigen::Vector3d> axes_b;
};

/// The parts of a NamedSpacecraft, with their units and frames. See PlainSpacecraft for what each is.
struct NamedHub {
  std::string name, inertial;
  HubMotion motion;
  MassProperties<ThisBody> mass;
};
struct NamedBody {
  std::string name, parent;
  MassProperties<ThisBody> mass;
  NamedJoint joint;
};
struct NamedRotor {
  std::string name, body;
  Vector<ThisBody, si::dimensionless> axis_b;
  Quantity<si::moment_of_inertia> inertia;
};
/// The participations are per root of the modal mass, kg^1/2 m and kg^1/2, for which there is no unit.
struct NamedMode {
  std::string name, body;
  Eigen::Vector3d rotation_b, translation_b;
  Quantity<si::angular_velocity> frequency;
  double damping_ratio;
};

}  // namespace vectrix
