#include <vectrix/dynamics/craft/plain_spacecraft.hpp>

#include "named_craft_core.hpp"

namespace vectrix {
namespace {

struct Mass {
  double mass;
  const Eigen::Vector3d& centre;
  const Eigen::Matrix3d& inertia;
};
std::ostream& operator<<(std::ostream& out, const Mass& body) {
  detail::print_column(out << body.mass << " kg at ", body.centre, "m");
  return detail::print_square(out << ", ", body.inertia) << " kg m^2";
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const PlainSpacecraft& craft) {
  using detail::in_quotes;
  out << in_quotes(craft.hub) << (craft.motion == HubMotion::free ? " free in " : " turning in ")
      << in_quotes(craft.inertial) << ": " << Mass{craft.mass, craft.r_hc_h, craft.J_c_h} << '\n';
  for (const PlainBody& body : craft.bodies) {
    out << in_quotes(body.name) << " on " << in_quotes(body.parent) << ", " << detail::name_of(body.joint);
    for (const auto& axis : body.axes_b) detail::print_column(out << ' ', axis, "");
    detail::print_column(out << " at ", body.r_pb_p, "m");
    if (body.R_p_from_b != Eigen::Matrix3d::Identity())
      detail::print_square(out << " turned ", body.R_p_from_b);
    out << ": " << Mass{body.mass, body.r_bc_b, body.J_c_b} << '\n';
  }
  for (const PlainRotor& rotor : craft.rotors) {
    detail::print_column(out << in_quotes(rotor.name) << " in " << in_quotes(rotor.body) << ", rotor ",
                         rotor.axis_b, "")
        << ": " << rotor.inertia << " kg m^2\n";
  }
  for (const PlainMode& mode : craft.modes) {
    out << in_quotes(mode.name) << " of " << in_quotes(mode.body) << ", mode: " << mode.frequency
        << " rad/s, damping " << mode.damping_ratio;
    detail::print_column(out << ", rotation ", mode.rotation_b, "kg^1/2 m");
    detail::print_column(out << ", translation ", mode.translation_b, "kg^1/2") << '\n';
  }
  return out;
}

}  // namespace vectrix
