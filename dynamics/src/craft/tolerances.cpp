#include <vectrix/dynamics/craft/tolerances.hpp>

#include "named_craft_core.hpp"

namespace vectrix {

std::vector<double> absolute_tolerances(const PlainSpacecraft& craft, const CraftTolerances& by) {
  const double angle = by.angle.value(), rate = by.rate.value(), length = by.length.value(),
               velocity = by.velocity.value();
  std::vector<double> list{angle, angle, angle, angle, rate, rate, rate};
  if (craft.motion == HubMotion::free)
    list.insert(list.end(), {length, length, length, velocity, velocity, velocity});
  const auto add = [&](std::size_t detail::JointCounts::*count, double turning, double moving,
                       std::size_t turns) {
    for (const PlainBody& body : craft.bodies) {
      const std::size_t all = detail::counts_of(body.joint).*count;
      for (std::size_t i = 0; i < all; ++i)
        list.push_back(body.joint == JointKind::slider || i >= turns ? moving : turning);
    }
  };
  add(&detail::JointCounts::positions, angle, length, 4);
  add(&detail::JointCounts::speeds, rate, velocity, 3);
  list.insert(list.end(), craft.rotors.size(), rate);
  list.insert(list.end(), 2 * craft.modes.size(), by.mode);
  return list;
}

}  // namespace vectrix
