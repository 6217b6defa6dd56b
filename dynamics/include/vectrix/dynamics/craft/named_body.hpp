#pragma once

#include <utility>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/mass/mass_properties.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix {

/// The frames of a body that has its name at run time, and of the body on which it hangs. They keep the
/// numbers of the two apart.
struct ThisBody : moving_frame {};
struct ParentBody : moving_frame {};

/// A joint, with the place of the body at zero. Made by hinge(), slider(), gimbal(), ball(), free_joint() and
/// fixed_joint().
struct NamedJoint {
  JointKind kind;
  Transform<ParentBody, ThisBody> X_p_from_b;
  std::vector<Vector<ThisBody, si::dimensionless>> axes_b;
};

namespace detail {

using MountOfBody = Transform<ParentBody, ThisBody>;
using AxisOfBody = Vector<ThisBody, si::dimensionless>;

}  // namespace detail

/// b turns about a unit vector that is fixed in b and in its parent.
inline NamedJoint hinge(const detail::MountOfBody& X_p_from_b, const detail::AxisOfBody& axis_b) {
  return {JointKind::hinge, X_p_from_b, {axis_b}};
}
/// b slides along a unit vector that is fixed in b and in its parent.
inline NamedJoint slider(const detail::MountOfBody& X_p_from_b, const detail::AxisOfBody& axis_b) {
  return {JointKind::slider, X_p_from_b, {axis_b}};
}
/// b turns about axis 1, fixed in its parent, and then about axis 2, fixed in b; both in b's axes at zero.
inline NamedJoint gimbal(const detail::MountOfBody& X_p_from_b, const detail::AxisOfBody& axis_1_b,
                         const detail::AxisOfBody& axis_2_b) {
  return {JointKind::gimbal, X_p_from_b, {axis_1_b, axis_2_b}};
}
/// b turns freely about its origin, which its parent holds.
inline NamedJoint ball(const detail::MountOfBody& X_p_from_b) {
  return {JointKind::ball, X_p_from_b, {}};
}
/// b moves freely; its numbers are counted from the given place.
inline NamedJoint free_joint(const detail::MountOfBody& X_p_from_b) {
  return {JointKind::free, X_p_from_b, {}};
}
inline NamedJoint fixed_joint(const detail::MountOfBody& X_p_from_b) {
  return {JointKind::fixed, X_p_from_b, {}};
}

template <class MountGiven, class AxisGiven>
auto hinge(  // hinge(X_p_from_b, axis_b): b is ThisBody, p ParentBody
    const MountGiven&, const AxisGiven&) -> Refused = delete;
template <class MountGiven, class AxisGiven>
auto slider(  // slider(X_p_from_b, axis_b): b is ThisBody, p ParentBody
    const MountGiven&, const AxisGiven&) -> Refused = delete;
template <class MountGiven, class FirstAxisGiven, class SecondAxisGiven>
auto gimbal(  // gimbal(X_p_from_b, axis_1_b, axis_2_b): b is ThisBody, p ParentBody
    const MountGiven&, const FirstAxisGiven&, const SecondAxisGiven&) -> Refused = delete;
template <class MountGiven> auto ball(const MountGiven&) -> Refused = delete;        // ball(X_p_from_b)
template <class MountGiven> auto free_joint(const MountGiven&) -> Refused = delete;  // free_joint(X_p_from_b)
template <class MountGiven>
auto fixed_joint(const MountGiven&) -> Refused = delete;  // fixed_joint(X_p_from_b)

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
