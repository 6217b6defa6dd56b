#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vectrix/dynamics/craft/craft_core.hpp>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {
namespace {

bool is_finite(const multibody::Column<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
std::string said(const std::string& what, const std::string& name, const std::string& number,
                 const char* unit) {
  return "the " + what + " on " + name + " is " + number + " " + unit;
}
/// Nothing if the vector is finite.
std::string said(const char* what, const std::string& name, const multibody::Column<double>& v,
                 const char* unit, const std::string& axes) {
  if (is_finite(v)) return "";
  return said(what, name, "(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")", unit) +
         " in the axes of " + axes;
}

/// The numbers of the joint of a body.
struct JointLoad {
  std::span<const double> efforts, given;
};
std::string of_joint(const PlainBody& body, const JointLoad& load) {
  const auto unit = [&](std::size_t i, const char* turns, const char* slides) {
    return body.joint == JointKind::slider || (body.joint == JointKind::free && i >= 3) ? slides : turns;
  };
  const auto name = [&](const char* what, std::size_t i) {
    return std::string(what) + (load.efforts.size() == 1 ? "" : " " + text(i + 1));
  };
  for (std::size_t i = 0; i < load.efforts.size(); ++i) {
    if (!std::isfinite(load.efforts[i]))
      return said(name("effort", i), "the joint of " + body.name, text(load.efforts[i]), unit(i, "N m", "N"));
    if (!std::isfinite(load.given[i]))
      return said(name("given acceleration", i), "the joint of " + body.name, text(load.given[i]),
                  unit(i, "rad/s^2", "m/s^2"));
  }
  return "";
}

}  // namespace

std::string not_finite_load(const PlainSpacecraft& craft, const multibody::Work<double>& work) {
  const auto of_body = [&](const std::string& name, const multibody::Articulated<double>& I) {
    const multibody::Column<double> zero =
        multibody::zero_column<double>();  // minus a NaN would be printed with its sign
    const std::string force = said("force", name, zero - I.f, "N", craft.hub);
    return force.empty() ? said("torque", name, zero - I.n, "N m", craft.hub) : force;
  };
  std::string found = of_body(craft.hub, work.hub);
  std::size_t link = 0, speed = 0;
  for (std::size_t i = 0; found.empty() && i < craft.bodies.size(); ++i) {
    const PlainBody& body = craft.bodies[i];
    const JointCounts counts = counts_of(body.joint);
    link += counts.links;
    found = of_joint(body, {std::span(work.efforts).subspan(speed, counts.speeds),
                            std::span(work.given).subspan(speed, counts.speeds)});
    if (found.empty()) found = of_body(body.name, work.links[link - 1].I);
    speed += counts.speeds;
  }
  for (std::size_t i = 0; found.empty() && i < craft.rotors.size(); ++i) {
    const std::string& name = craft.rotors[i].name;
    if (!std::isfinite(work.motors[i])) found = said("motor torque", name, text(work.motors[i]), "N m");
    if (!std::isfinite(work.given_spins[i]))
      found = said("given acceleration", name, text(work.given_spins[i]), "rad/s^2");
  }
  for (std::size_t i = 0; found.empty() && i < craft.modes.size(); ++i)
    if (!std::isfinite(work.modal[i]))
      found = said("force", craft.modes[i].name, text(work.modal[i]), "kg^1/2 m/s^2");
  return found.empty() ? said("field", "the craft", work.field, "m/s^2", craft.inertial) : found;
}

std::string first_not_finite_load(const PlainSpacecraft& craft, std::size_t count,
                                  const std::function<const multibody::Work<double>&(std::size_t)>& of_load) {
  for (std::size_t i = 1; i <= count; ++i) {
    const std::string found = not_finite_load(craft, of_load(i));
    if (!found.empty()) return "load " + text(i) + " of " + text(count) + ": " + found;
  }
  const std::string found = not_finite_load(craft, of_load(0));
  return found.empty() ? found : "the loads together: " + found;
}

}  // namespace vectrix::detail
