#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix {

/// A joint of a kind by which the body b hangs on p. It has the name of b. Made by hinge(), slider(),
/// gimbal(), ball(), free_joint() and fixed_joint(); `X_p_from_b` is where b is while the joint's numbers are
/// zero, and the origin of b lies on its joint.
template <JointKind kind, Frame P, Frame B> struct BodyJoint {
  Transform<P, B> X_p_from_b;
  std::vector<Eigen::Vector3d> axes_b;  ///< in the axes of b
};

/// b turns about a unit vector that is fixed in b and in its parent.
template <class P, class B>
  requires(!std::is_same_v<P, B>)
BodyJoint<JointKind::hinge, P, B> hinge(const Transform<P, B>& X_p_from_b,
                                        const Vector<B, si::dimensionless>& axis_b) {
  return {X_p_from_b, {axis_b.coordinates()}};
}
template <class P, class B, class C, class U>
  requires(std::is_same_v<P, B> || !std::is_same_v<B, C> || !std::is_same_v<U, si::dimensionless>)
auto hinge(  // hinge(X_p_from_b, axis_b): b on another frame p; a unit vector in the frame b that turns
    const Transform<P, B>&, const Vector<C, U>&) -> Refused = delete;

/// b slides along a unit vector that is fixed in b and in its parent.
template <class P, class B>
  requires(!std::is_same_v<P, B>)
BodyJoint<JointKind::slider, P, B> slider(const Transform<P, B>& X_p_from_b,
                                          const Vector<B, si::dimensionless>& axis_b) {
  return {X_p_from_b, {axis_b.coordinates()}};
}
template <class P, class B, class C, class U>
  requires(std::is_same_v<P, B> || !std::is_same_v<B, C> || !std::is_same_v<U, si::dimensionless>)
auto slider(  // slider(X_p_from_b, axis_b): b on another frame p; a unit vector in the frame b that slides
    const Transform<P, B>&, const Vector<C, U>&) -> Refused = delete;

/// b turns about axis 1, fixed in its parent, and then about axis 2, fixed in b; both in b's axes at zero.
template <class P, class B>
  requires(!std::is_same_v<P, B>)
BodyJoint<JointKind::gimbal, P, B> gimbal(const Transform<P, B>& X_p_from_b,
                                          const Vector<B, si::dimensionless>& axis_1_b,
                                          const Vector<B, si::dimensionless>& axis_2_b) {
  return {X_p_from_b, {axis_1_b.coordinates(), axis_2_b.coordinates()}};
}
template <class P, class B, class C, class U, class D, class V>
  requires(std::is_same_v<P, B> || !std::is_same_v<Vector<C, U>, Vector<B, si::dimensionless>> ||
           !std::is_same_v<Vector<D, V>, Vector<B, si::dimensionless>>)
auto gimbal(  // gimbal(X_p_from_b, axis_1_b, axis_2_b): b on another frame p; unit vectors in the frame b
              // that turns
    const Transform<P, B>&, const Vector<C, U>&, const Vector<D, V>&) -> Refused = delete;

/// b turns freely about its origin, which its parent holds.
template <class P, class B>
  requires(!std::is_same_v<P, B>)
BodyJoint<JointKind::ball, P, B> ball(const Transform<P, B>& X_p_from_b) {
  return {X_p_from_b, {}};
}
/// b moves freely; its numbers are counted from the given place.
template <class P, class B>
  requires(!std::is_same_v<P, B>)
BodyJoint<JointKind::free, P, B> free_joint(const Transform<P, B>& X_p_from_b) {
  return {X_p_from_b, {}};
}
template <class P, class B>
  requires(!std::is_same_v<P, B>)
BodyJoint<JointKind::fixed, P, B> fixed_joint(const Transform<P, B>& X_p_from_b) {
  return {X_p_from_b, {}};
}
template <class B> auto ball(const Transform<B, B>&) -> Refused = delete;         // b hangs on another frame
template <class B> auto free_joint(const Transform<B, B>&) -> Refused = delete;   // b hangs on another frame
template <class B> auto fixed_joint(const Transform<B, B>&) -> Refused = delete;  // b hangs on another frame

/// One of the two axes of a gimbal: about_axis<1>, about_axis<2>.
template <int axis> struct AboutAxis {};
template <int axis>
  requires(axis == 1 || axis == 2)
inline constexpr AboutAxis<axis> about_axis{};

/// How the hub moves in an inertial frame: with attitude and position as states, or the attitude alone.
template <InertialFrame I, HubMotion motion> struct MovesIn {};
template <InertialFrame I> inline constexpr MovesIn<I, HubMotion::free> free_in{};
template <InertialFrame I> inline constexpr MovesIn<I, HubMotion::turning> turning_in{};

}  // namespace vectrix
