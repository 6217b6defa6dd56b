#pragma once

#include <string>
#include <vectrix/dynamics/load/finite.hpp>
#include <vectrix/dynamics/load/joint_units.hpp>

namespace vectrix {

/// A load: the effort -k (q - q_0) on a hinge or slider.
template <CraftType C, class B, class K, class Q> struct JointSpring {
  Quantity<K> stiffness;
  Quantity<Q> at_rest;
  template <class S> void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    forces.effort(of<B>, -(stiffness * (now.coordinate(of<B>) - at_rest)));
  }
};
/// A load: the effort -c u on a hinge or slider.
template <CraftType C, class B, class D> struct JointDamper {
  Quantity<D> damping;
  template <class S> void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    forces.effort(of<B>, -(damping * now.speed(of<B>)));
  }
};

/// A spring on the joint of b, N m/rad or N/m, and where it is at rest. Throws BadInput for a number that is
/// not finite.
template <CraftType C, class B, class K, class Q>
  requires(detail::is_stiffness<C, B, K, Q>())
JointSpring<C, B, K, Q> spring(const C&, Of<B>, const Quantity<K>& stiffness, const Quantity<Q>& at_rest) {
  const auto load = detail::on_joint<B>("spring");
  return {detail::finite(load, "stiffness", stiffness), detail::finite(load, "place of rest", at_rest)};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto spring(  // spring(craft, of<B>, k, q_0): b on a hinge, N m/rad and rad, or on a slider, N/m and m
    const Given&...) -> Refused = delete;

/// A damper on the joint of b, N m s/rad or N s/m. Throws BadInput for a number that is not finite.
template <CraftType C, class B, class D>
  requires(detail::is_damping<detail::AxisUnits<C, B>, D>())
JointDamper<C, B, D> damper(const C&, Of<B>, const Quantity<D>& damping) {
  return {detail::finite(detail::on_joint<B>("damper"), "damping", damping)};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto damper(  // damper(craft, of<B>, c): b on a hinge, N m s/rad, or on a slider, N s/m
    const Given&...) -> Refused = delete;

}  // namespace vectrix
