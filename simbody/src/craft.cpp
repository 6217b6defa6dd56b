#include <cstddef>
#include <string>
#include <unordered_map>
#include <vectrix/simbody/propagate.hpp>

namespace vectrix::detail {
namespace {

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
    case JointKind::ball:
      return SimbodyJoint::ball;
    case JointKind::free:
      return SimbodyJoint::free;
    case JointKind::gimbal:
    case JointKind::fixed:
      break;
  }
  return SimbodyJoint::fixed;
}

}  // namespace

SimbodyCraft simbody_craft(const PlainSpacecraft& craft) {
  SimbodyCraft made{craft.hub,
                    craft.motion == HubMotion::free,
                    craft.mass,
                    three(craft.r_hc_h),
                    by_rows(craft.J_c_h),
                    {},
                    {},
                    {}};
  const auto last = [&] { return static_cast<int>(made.links.size()); };
  std::unordered_map<std::string, int> links{{craft.hub, 0}};
  for (const PlainBody& body : craft.bodies) {
    const auto hang = [&](const std::string& name, SimbodyJoint joint, int parent,
                          const Eigen::Vector3d& axis) {
      made.links.push_back({name, joint, parent, by_rows(body.R_p_from_b), three(body.r_pb_p), three(axis),
                            body.mass, three(body.r_bc_b), by_rows(body.J_c_b)});
    };
    const int parent = links.at(body.parent);
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    if (body.joint == JointKind::gimbal) {
      hang("the ring of " + body.name, SimbodyJoint::hinge, parent, body.axes_b[0]);
      made.links.back().mass = 0.0;
      made.links.back().inertia_c_b = {};
      hang(body.name, SimbodyJoint::hinge, last(), body.axes_b[1]);
      made.links.back().R_p_from_b = by_rows(Eigen::Matrix3d::Identity());
      made.links.back().r_pb_p = three(none);
    } else {
      hang(body.name, joint_of(body.joint), parent, body.axes_b.empty() ? none : body.axes_b.front());
    }
    links.emplace(body.name, last());
  }
  for (const PlainRotor& rotor : craft.rotors)
    made.rotors.push_back({links.at(rotor.body), three(rotor.axis_b), rotor.inertia});
  for (const PlainMode& mode : craft.modes)
    made.modes.push_back({links.at(mode.body), three(mode.rotation_b), three(mode.translation_b),
                          mode.frequency, mode.damping_ratio});
  return made;
}

static bool is_at_rest(multibody::Hold hold) {
  return hold == multibody::Hold::locked || hold == multibody::Hold::sticks;
}

void copy_loads(const multibody::Work<double>& found, SimbodyLoads& loads) {
  const std::size_t links = found.links.size();
  loads.forces.resize(links + 1);
  loads.torques.resize(links + 1);
  loads.locked_links.resize(links);
  loads.driven_links.resize(links);
  const auto wrench = [&](std::size_t body, const multibody::Articulated<double>& I) {
    loads.forces[body] = three(-I.f);
    loads.torques[body] = three(-I.n);
  };
  wrench(0, found.hub);
  for (std::size_t i = 0; i < links; ++i) {
    wrench(i + 1, found.links[i].I);
    loads.locked_links[i] = is_at_rest(found.held[i]);
    loads.driven_links[i] = found.held[i] == multibody::Hold::driven;
  }
  loads.given = found.given;
  loads.efforts = found.efforts;
  loads.motors = found.motors;
  loads.modal = found.modal;
  loads.field_i = three(found.field);
  loads.given_spins = found.given_spins;
  loads.locked_rotors.resize(found.held_rotors.size());
  loads.driven_rotors.resize(found.held_rotors.size());
  for (std::size_t i = 0; i < found.held_rotors.size(); ++i) {
    loads.locked_rotors[i] = is_at_rest(found.held_rotors[i]);
    loads.driven_rotors[i] = found.held_rotors[i] == multibody::Hold::driven;
  }
}

}  // namespace vectrix::detail
