#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/frames/errors.hpp>
#include <vectrix/kinematics/named/frame.hpp>
#include <vectrix/simbody/propagate.hpp>

namespace vectrix::detail {
namespace {

/// Simbody builds a gimbal from two axes and makes the second orthogonal without a word.
constexpr double orthogonal = 1e-12;

std::array<double, 3> three(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
std::array<double, 3> three(const multibody::Column<double>& v) {
  return {v.x, v.y, v.z};
}
std::array<double, 9> by_rows(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

SimbodyJoint joint_of(JointKind kind) {
  switch (kind) {
    case JointKind::hinge:
      return SimbodyJoint::hinge;
    case JointKind::slider:
      return SimbodyJoint::slider;
    case JointKind::gimbal:
      return SimbodyJoint::gimbal;
    case JointKind::ball:
      return SimbodyJoint::ball;
    case JointKind::free:
      return SimbodyJoint::free;
    case JointKind::fixed:
      break;
  }
  return SimbodyJoint::fixed;
}

}  // namespace

SimbodyCraft simbody_craft(const char* action, const PlainSpacecraft& craft) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput(std::string(action) + " " + craft.hub + ": " + why);
  };
  if (!craft.modes.empty())
    refuse("Simbody has no modes, and the craft has " + text(craft.modes.size()) + ", the first " +
           in_quotes(craft.modes.front().name));
  const auto number = [&](const std::string& name) {
    const auto found = std::find_if(craft.bodies.begin(), craft.bodies.end(),
                                    [&](const PlainBody& body) { return body.name == name; });
    return name == craft.hub ? 0 : static_cast<int>(found - craft.bodies.begin()) + 1;
  };
  SimbodyCraft made{
      craft.hub, craft.motion == HubMotion::free, craft.mass, three(craft.r_hc_h), by_rows(craft.J_c_h), {},
      {}};
  for (const PlainBody& body : craft.bodies) {
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    if (body.joint == JointKind::gimbal) {
      const double cosine = body.axes_b[0].dot(body.axes_b[1]);
      if (std::abs(cosine) > orthogonal)
        refuse("Simbody's gimbal has orthogonal axes; between those of " + in_quotes(body.name) +
               " the cosine is " + text(cosine));
    }
    made.bodies.push_back({body.name, joint_of(body.joint), number(body.parent), by_rows(body.R_p_from_b),
                           three(body.r_pb_p), three(body.axes_b.empty() ? none : body.axes_b.front()),
                           three(body.axes_b.empty() ? none : body.axes_b.back()), body.mass,
                           three(body.r_bc_b), by_rows(body.J_c_b)});
  }
  for (const PlainRotor& rotor : craft.rotors)
    made.rotors.push_back({number(rotor.body), three(rotor.axis_b), rotor.inertia});
  return made;
}

void copy_loads(const PlainSpacecraft& craft, const multibody::Work<double>& found, SimbodyLoads& loads) {
  const std::size_t bodies = craft.bodies.size();
  loads.forces.resize(bodies + 1);
  loads.torques.resize(bodies + 1);
  loads.locked_joints.resize(bodies);
  const auto wrench = [&](std::size_t body, const multibody::Articulated<double>& I) {
    loads.forces[body] = three(-I.f);
    loads.torques[body] = three(-I.n);
  };
  wrench(0, found.hub);
  std::size_t link = 0;
  for (std::size_t b = 0; b < bodies; ++b) {
    link += counts_of(craft.bodies[b].joint).links;
    wrench(b + 1, found.links[link - 1].I);
    loads.locked_joints[b] = found.locked_links[link - 1];
  }
  loads.efforts = found.efforts;
  loads.motors = found.motors;
  loads.field_i = three(found.field);
  loads.locked_rotors = found.locked_rotors;
}

}  // namespace vectrix::detail
