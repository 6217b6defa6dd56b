#include "named_craft_core.hpp"

#include <algorithm>
#include <vectrix/dynamics/multibody/hinge.hpp>
#include <vectrix/dynamics/multibody/slider.hpp>
#include <vectrix/kinematics/named/nearest_name.hpp>

namespace vectrix::detail {
namespace {

multibody::Mass<double> mass_of(double mass, const Eigen::Vector3d& centre, const Eigen::Matrix3d& J_c) {
  const Eigen::Matrix3d J = about_origin(mass, centre, J_c);
  return {mass, numbers(Eigen::Vector3d(mass * centre)), symmetric(J)};
}

/// The place of a name in a list of parts, from 0; its size if there is none.
template <class Parts> std::size_t find_part(const Parts& parts, std::string_view name) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return part.name == name; });
  return static_cast<std::size_t>(found - parts.begin());
}

std::size_t body_number(const PlainSpacecraft& craft, std::string_view name) {
  return name == craft.hub ? 0 : find_part(craft.bodies, name) + 1;
}

multibody::TreeNumbers<double> tree_of(const PlainSpacecraft& craft, std::vector<int>& links) {
  multibody::TreeNumbers<double> tree{
      craft.motion, mass_of(craft.mass, craft.r_hc_h, craft.J_c_h), {}, {}, {}};
  const auto link_of = [&](const std::string& body) { return links[body_number(craft, body)]; };
  links.push_back(0);
  for (const PlainBody& body : craft.bodies) {
    const int parent = link_of(body.parent);
    const auto mass = mass_of(body.mass, body.r_bc_b, body.J_c_b);
    const Square3 R = numbers(body.R_p_from_b);
    const Column3 r = numbers(body.r_pb_p);
    const auto axis = [&](std::size_t i) { return numbers(Eigen::Vector3d(body.axes_b[i].normalized())); };
    const auto hang = [&](const multibody::Joint<double>& joint) {
      tree.links.push_back({parent, joint, mass});
    };
    switch (body.joint) {
      case JointKind::hinge:
        hang(multibody::hinge(R, axis(0), r));
        break;
      case JointKind::slider:
        hang(multibody::slider(R, axis(0), r));
        break;
      case JointKind::gimbal:
        multibody::add_gimbal(tree, parent, R, axis(0), axis(1), r, mass);
        break;
      case JointKind::ball:
        hang(multibody::joint(multibody::Kind::ball, R, r));
        break;
      case JointKind::free:
        hang(multibody::joint(multibody::Kind::free, R, r));
        break;
      case JointKind::fixed:
        hang(multibody::joint(multibody::Kind::fixed, R, r));
        break;
    }
    links.push_back(static_cast<int>(tree.links.size()));
  }
  for (const PlainRotor& rotor : craft.rotors)
    tree.rotors.push_back(
        {link_of(rotor.body), numbers(Eigen::Vector3d(rotor.axis_b.normalized())), rotor.inertia});
  for (const PlainMode& mode : craft.modes)
    tree.modes.push_back({link_of(mode.body), numbers(mode.rotation_b), numbers(mode.translation_b),
                          mode.frequency, mode.damping_ratio});
  return tree;
}

std::vector<std::string> component_names_of(const PlainSpacecraft& craft) {
  std::vector<std::string> names{"q0", "q1", "q2", "q3", "wx", "wy", "wz"};
  if (craft.motion == HubMotion::free)
    for (const char* name : {"rx", "ry", "rz", "vx", "vy", "vz"}) names.emplace_back(name);
  const auto add = [&](const char* what, std::size_t JointCounts::*count) {
    for (const PlainBody& body : craft.bodies)
      for (std::size_t i = 1; i <= counts_of(body.joint).*count; ++i)
        names.push_back(std::string{what} + text(i) + " of " + in_quotes(body.name));
  };
  add("position ", &JointCounts::positions);
  add("speed ", &JointCounts::speeds);
  for (const PlainRotor& rotor : craft.rotors) names.push_back("spin of " + in_quotes(rotor.name));
  for (const PlainMode& mode : craft.modes) names.push_back("coordinate of " + in_quotes(mode.name));
  for (const PlainMode& mode : craft.modes) names.push_back("rate of " + in_quotes(mode.name));
  return names;
}

CraftCore core_of(PlainSpacecraft craft, std::vector<int>& links) {
  multibody::Tree<double> tree(tree_of(craft, links));
  std::vector<std::string> names = component_names_of(craft);
  return {std::move(craft), std::move(tree), std::move(names), {}};
}

template <class Parts>
[[noreturn]] void no_part(const char* what, std::string_view name, const Parts& parts) {
  std::vector<std::string_view> names;
  for (const auto& part : parts) names.push_back(part.name);
  const std::string_view nearest = nearest_name(name, names);
  throw BadInput("no " + std::string{what} + " " + in_quotes(name) + " in the craft, which has " +
                 text(names.size()) + (nearest.empty() ? "" : "; the nearest name is " + in_quotes(nearest)));
}

}  // namespace

const char* name_of(JointKind kind) {
  constexpr const char* names[]{"hinge", "slider", "gimbal", "ball", "free", "fixed"};
  return names[static_cast<std::size_t>(kind)];
}

NamedCraftCore::NamedCraftCore(PlainSpacecraft given, const char* form)
    : core_(core_of(checked_craft(std::move(given), form), links_)) {
  const auto add = [&](const std::string& name, FrameMotion motion) {
    FrameRecord& frame = frames_.emplace_back();
    frame.graph = this;
    frame.name = name;
    frame.motion = motion;
    frame.number = static_cast<std::uint32_t>(frames_.size() - 1);
    numbers_.emplace(frame.name, frame.number);
  };
  add(core_.plain.inertial, FrameMotion::inertial);
  add(core_.plain.hub, FrameMotion::moving);
  for (const PlainBody& body : core_.plain.bodies) add(body.name, FrameMotion::moving);
}

NamedFrame NamedCraftCore::frame(std::string_view name) const {
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) no_part("frame", name, frames_);
  return frame(found->second);
}
NamedFrame NamedCraftCore::own(NamedFrame frame) const {
  if (frame.record().graph != this)
    throw BadInput("the frame " + in_quotes(frame) + " is not of the craft of " + in_quotes(core_.plain.hub));
  return frame;
}
int NamedCraftCore::link(NamedFrame body, const char* action) const {
  const std::size_t number = own(body).record().number;
  if (number == 0)
    throw BadInput(std::string{action} + ": " + in_quotes(body) + " is the inertial frame, not a body");
  return links_[number - 1];
}

NamedCraftCore::Joint NamedCraftCore::joint(std::string_view body) const {
  const auto found = numbers_.find(body);
  if (found == numbers_.end() || found->second < 2) no_part("joint", body, core_.plain.bodies);
  const std::size_t number = found->second - 1;  // the hub is 0
  const PlainBody& given = core_.plain.bodies[number - 1];
  const std::size_t last = static_cast<std::size_t>(links_[number]) - 1;
  return {&given, last + 1 - counts_of(given.joint).links};
}
std::optional<std::size_t> NamedCraftCore::find_rotor(std::string_view name) const {
  const std::size_t found = find_part(core_.plain.rotors, name);
  return found < core_.plain.rotors.size() ? std::optional{found} : std::nullopt;
}
std::size_t NamedCraftCore::rotor(std::string_view name) const {
  const auto found = find_rotor(name);
  if (!found) no_part("rotor", name, core_.plain.rotors);
  return *found;
}
std::size_t NamedCraftCore::mode(std::string_view name) const {
  const std::size_t found = find_part(core_.plain.modes, name);
  if (found == core_.plain.modes.size()) no_part("mode", name, core_.plain.modes);
  return found;
}

std::size_t NamedCraftCore::position_at(const Joint& joint, int axis) const {
  return core_.tree.layout().position_at[joint.link + static_cast<std::size_t>(axis - 1)];
}
std::size_t NamedCraftCore::speed_at(const Joint& joint, int axis) const {
  return core_.tree.layout().speed_at[joint.link + static_cast<std::size_t>(axis - 1)] -
         core_.tree.layout().speeds_begin();
}

}  // namespace vectrix::detail
