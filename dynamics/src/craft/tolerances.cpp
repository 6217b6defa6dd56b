#include <vectrix/dynamics/craft/tolerances.hpp>

#include "named_craft_core.hpp"

namespace vectrix {

namespace {

void require_given(const PlainSpacecraft& craft, const CraftTolerances& by) {
  bool slides = craft.motion == HubMotion::free;
  for (const PlainBody& body : craft.bodies)
    slides = slides || body.joint == JointKind::slider || body.joint == JointKind::free;
  const auto require = [&](bool needed, double tolerance, const char* name) {
    if (needed && tolerance == 0.0)
      throw BadInput("the absolute tolerances of the craft of " + detail::in_quotes(craft.hub) + ": ." +
                     name + " is left out, or 0; none has a default");
  };
  require(true, by.angle.value(), "angle");
  require(true, by.rate.value(), "rate");
  require(slides, by.length.value(), "length");
  require(slides, by.velocity.value(), "velocity");
  require(!craft.modes.empty(), by.mode, "mode");
}

}  // namespace

std::vector<double> absolute_tolerances(const PlainSpacecraft& craft, const CraftTolerances& by) {
  require_given(craft, by);
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
