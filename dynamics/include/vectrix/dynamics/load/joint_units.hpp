#pragma once

#include <type_traits>
#include <vectrix/dynamics/craft/forces.hpp>
#include <vectrix/dynamics/load/finite.hpp>
#include <vectrix/frames/frame.hpp>

namespace vectrix::detail {

/// The units of what turns or slides along one axis: a hinge, a slider, and if `rotors` a rotor; else void.
template <class C, class On, bool rotors = false>
using AxisUnits =
    std::conditional_t<C::shape::template has_joint_of<On, JointKind::hinge> ||
                           (rotors && C::shape::template has_rotor<On>),
                       JointUnits<JointKind::hinge>,
                       std::conditional_t<C::shape::template has_joint_of<On, JointKind::slider>,
                                          JointUnits<JointKind::slider>, void>>;

/// "friction on Panel".
template <class On> LoadName on_joint(const char* load) {
  return {load, frame_name<On>};
}

/// Whether the joint of b has the coordinate Q, and K times Q is its effort.
template <class C, class B, class K, class Q> constexpr bool is_stiffness() {
  using Units = AxisUnits<C, B>;
  if constexpr (!std::is_void_v<Units>)
    return std::is_same_v<Q, typename Units::coordinate> &&
           std::is_same_v<unit_product<K, Q>, typename Units::effort>;
  return false;
}
/// Whether D times the speed is the effort, of things with such units.
template <class Units, class D> constexpr bool is_damping() {
  if constexpr (!std::is_void_v<Units>)
    return std::is_same_v<unit_product<D, typename Units::speed>, typename Units::effort>;
  return false;
}

}  // namespace vectrix::detail
