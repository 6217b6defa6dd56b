#pragma once

#include <vectrix/dynamics/multibody/tree.hpp>

/// The numbers of a tree in another scalar.
namespace vectrix::multibody {

template <class S, class From> Column<S> converted(const Column<From>& v) {
  return {S(v.x), S(v.y), S(v.z)};
}
template <class S, class From> Square<S> converted(const Square<From>& m) {
  return {converted<S>(m.x), converted<S>(m.y), converted<S>(m.z)};
}
template <class S, class From> Symmetric<S> converted(const Symmetric<From>& m) {
  return {S(m.xx), S(m.yy), S(m.zz), S(m.xy), S(m.xz), S(m.yz)};
}
template <class S, class From> Mass<S> converted(const Mass<From>& b) {
  return {S(b.m), converted<S>(b.mc), converted<S>(b.J)};
}
template <class S, class From> Link<S> converted(const Link<From>& link) {
  const Joint<From>& j = link.joint;
  return {link.parent,
          {j.kind, converted<S>(j.K0), converted<S>(j.K1), converted<S>(j.K2), converted<S>(j.axis_p),
           converted<S>(j.origin_p)},
          converted<S>(link.mass)};
}
template <class S, class From> TreeNumbers<S> converted(const TreeNumbers<From>& tree) {
  TreeNumbers<S> numbers{tree.hub_motion, converted<S>(tree.hub), {}, {}, {}};
  for (const auto& link : tree.links) numbers.links.push_back(converted<S>(link));
  for (const auto& rotor : tree.rotors)
    numbers.rotors.push_back({rotor.body, converted<S>(rotor.axis), S(rotor.inertia)});
  for (const auto& mode : tree.modes)
    numbers.modes.push_back({mode.body, converted<S>(mode.rotation), converted<S>(mode.translation),
                             S(mode.frequency), S(mode.damping_ratio)});
  return numbers;
}

}  // namespace vectrix::multibody
