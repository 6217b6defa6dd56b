#pragma once

#include <string>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/mass/mass_properties.hpp>
#include <vectrix/frames/transform.hpp>

namespace vectrix::detail {

/// A craft of its hub alone.
template <class Whole, class H>
PlainSpacecraft plain_hub(std::string inertial, std::string name, HubMotion motion,
                          const MassProperties<Whole, H, In<H>>& mass) {
  return {std::move(inertial),
          std::move(name),
          motion,
          mass.mass().value(),
          mass.centre().coordinates(),
          mass.inertia().matrix(),
          {},
          {},
          {}};
}
template <class Whole, class P, class B>
PlainBody plain_body(std::string name, std::string parent, JointKind joint, const Transform<P, B>& X_p_from_b,
                     const std::vector<Vector<B, si::dimensionless>>& axes_b,
                     const MassProperties<Whole, B, In<B>>& mass) {
  PlainBody body{std::move(name),
                 std::move(parent),
                 joint,
                 {},
                 X_p_from_b.rotation.matrix(),
                 X_p_from_b.translation.coordinates(),
                 mass.mass().value(),
                 mass.centre().coordinates(),
                 mass.inertia().matrix()};
  for (const auto& axis_b : axes_b) body.axes_b.push_back(axis_b.coordinates());
  return body;
}

}  // namespace vectrix::detail
