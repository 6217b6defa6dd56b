#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vectrix/dynamics/mass/mass_properties.hpp>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/named/nearest_name.hpp>
#include <vectrix/kinematics/named/some.hpp>
#include <vectrix/kinematics/rates/hat.hpp>

#include "named_craft_core.hpp"

namespace vectrix::detail {
namespace {

constexpr double least_angle =
    1e-6;  // between the axes of a gimbal, rad: rounding grows as its inverse square

[[noreturn]] void refuse(const std::string& part, const std::string& fault) {
  throw BadInput(part + ": " + fault);
}
/// Calls a typed door; its errors get the name of the part, also where they say its frame or its parent's.
template <class Door>
auto through(const std::string& part, const Door& door, const std::string& parent = "its parent") {
  try {
    return door();
  } catch (const BadInput& error) {
    std::string said = error.what();
    put_name(said, frame_name<ThisBody>(), part.substr(1, part.size() - 2));
    put_name(said, frame_name<ParentBody>(), parent);
    refuse(part, said);
  }
}

std::string triple(const Eigen::Vector3d& v) {
  return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}
void require_finite(const std::string& part, const char* what, const Eigen::Vector3d& v) {
  if (!v.allFinite()) refuse(part, std::string{what} + " " + triple(v) + " is not finite");
}
void require_axis(const std::string& part, const Eigen::Vector3d& axis) {
  if (!(std::abs(axis.norm() - 1.0) <= unit_norm_tolerance))
    refuse(part, "the axis " + triple(axis) + " is not a unit vector, its norm is " + text(axis.norm()));
}

void require_size(const std::string& part, const char* what, double size, const char* unit) {
  if (!has_size(size)) refuse(part, std::string{what} + " is " + text(size) + unit + sizes_of_a_craft());
}

void check_mass(const std::string& part, double mass, const Eigen::Vector3d& centre,
                const Eigen::Matrix3d& J) {
  through(part, [&] {
    const auto r_bc_b = displacement(of<CentreOfMassOf<ThisBody>>, relative_to<ThisBody>,
                                     vector<si::length>(in<ThisBody>, centre));
    return mass_properties(mass * si::kilogram, r_bc_b, inertia_from_tensor(in<ThisBody>, J));
  });
  require_size(part, "its mass", mass, " kg");
  if (const double trace = about_origin(mass, centre, J).trace(); trace != 0.0)
    require_size(part, "the sum of its moments of inertia about its origin", trace, " kg m^2");
}

void check_joint(const std::string& part, const PlainBody& body) {
  through(
      part, [&] { return dcm(to<ParentBody>, from<ThisBody>, body.R_p_from_b); }, body.parent);
  require_finite(part, "the position on the parent", body.r_pb_p);
  if (const std::size_t axes = counts_of(body.joint).axes; body.axes_b.size() != axes) {
    refuse(part, "a " + std::string{name_of(body.joint)} + " joint has " + text(axes) + " axes, not " +
                     text(body.axes_b.size()));
  }
  for (const auto& axis : body.axes_b) require_axis(part, axis);
  if (body.joint == JointKind::gimbal) {
    const double sine = body.axes_b[0].cross(body.axes_b[1]).norm();
    if (sine < least_angle)
      refuse(part, "the axes of the gimbal are parallel, the sine between them is " + text(sine));
  }
  const Eigen::Matrix3d J = about_origin(body.mass, body.r_bc_b, body.J_c_b);
  const double least = moment_tolerance<double>() * J.trace();
  const auto require_inertia = [&](double moment, const char* about) {
    if (!(moment > least))
      refuse(part, "its inertia about " + std::string{about} + " is " + text(moment) +
                       " kg m^2: it would turn at once");
  };
  if (body.joint == JointKind::hinge)
    require_inertia(body.axes_b[0].dot(J * body.axes_b[0]), "the axis of its hinge");
  if (body.joint == JointKind::gimbal) {
    require_inertia(body.axes_b[0].dot(J * body.axes_b[0]), "the first axis of its gimbal");
    require_inertia(body.axes_b[1].dot(J * body.axes_b[1]), "the second axis of its gimbal");
  }
  if (body.joint == JointKind::ball || body.joint == JointKind::free)
    require_inertia(
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(J, Eigen::EigenvaluesOnly).eigenvalues()[0],
        "its thinnest axis");
}

void check_names(const PlainSpacecraft& craft) {
  std::vector<std::pair<std::string, std::string>> names{{craft.inertial, "the inertial frame"},
                                                         {craft.hub, "the hub"}};
  for (const auto& body : craft.bodies) names.emplace_back(body.name, "a body");
  for (const auto& rotor : craft.rotors) names.emplace_back(rotor.name, "a rotor");
  for (const auto& mode : craft.modes) names.emplace_back(mode.name, "a mode");
  for (const auto& [name, what] : names)
    if (name.empty()) throw BadInput(what + " has no name");
  std::stable_sort(names.begin(), names.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto twice = std::adjacent_find(names.begin(), names.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != names.end()) {
    throw BadInput("the name " + in_quotes(twice->first) + " is that of " + twice->second + " and of " +
                   std::next(twice)->second);
  }
}

void require_body(const std::string& part, const std::string& name,
                  const std::vector<std::string_view>& bodies) {
  if (std::find(bodies.begin(), bodies.end(), name) != bodies.end()) return;
  const std::string_view nearest = nearest_name(name, bodies);
  refuse(part, "there is no body " + in_quotes(name) +
                   (nearest.empty() ? "" : "; the nearest name is " + in_quotes(nearest)));
}

/// Parents first, else in the given order.
std::vector<PlainBody> in_order(const PlainSpacecraft& craft) {
  std::vector<PlainBody> ordered, left = craft.bodies;
  std::vector<std::string_view> placed{craft.hub};
  const auto hangs = [&](const PlainBody& body) {
    return std::find(placed.begin(), placed.end(), body.parent) != placed.end();
  };
  ordered.reserve(left.size());
  while (!left.empty()) {
    const auto next = std::find_if(left.begin(), left.end(), hangs);
    if (next == left.end()) {
      // Every one of them hangs on another of them: follow the parents until one comes again.
      std::vector<std::string> way{left.front().name};
      while (std::count(way.begin(), way.end(), way.back()) < 2) {
        way.push_back(std::find_if(left.begin(), left.end(), [&](const PlainBody& body) {
                        return body.name == way.back();
                      })->parent);
      }
      way.erase(way.begin(), std::find(way.begin(), way.end(), way.back()));
      std::string loop = in_quotes(way.front());
      for (std::size_t i = 1; i < way.size(); ++i) loop += " - " + in_quotes(way[i]);
      throw BadInput("bodies hang on each other in a loop, " + loop);
    }
    ordered.push_back(*next);
    placed.push_back(ordered.back().name);
    left.erase(next);
  }
  return ordered;
}

/// Rotors and modes leave their body some inertia: [J, mc~; -mc~, m] - sum d d^T is positive.
void check_internals(const PlainSpacecraft& craft, const std::string& name, double mass,
                     const Eigen::Vector3d& centre, const Eigen::Matrix3d& J_c) {
  using Six = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  const Eigen::Matrix3d first = mass * hat(centre);
  Six left;
  left << about_origin(mass, centre, J_c), first, -first, mass * Eigen::Matrix3d::Identity();
  const auto positive = [](const Six& matrix) { return Eigen::LLT<Six>(matrix).info() == Eigen::Success; };
  Eigen::Matrix3d of_rotors = Eigen::Matrix3d::Zero();
  for (const auto& rotor : craft.rotors) {
    if (rotor.body != name) continue;
    const bool first_one = of_rotors.isZero(0.0);
    const Eigen::Matrix3d added = rotor.inertia * rotor.axis_b * rotor.axis_b.transpose();
    of_rotors += added;
    left.topLeftCorner<3, 3>() -= added;
    if (positive(left)) continue;
    const std::string part = "rotor " + in_quotes(rotor.name);
    if (first_one)
      refuse(part, "its inertia, " + text(rotor.inertia) + " kg m^2, is more than that of its body " +
                       in_quotes(name));
    const Eigen::Matrix3d rest = J_c - of_rotors;
    const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rest).eigenvectors().col(0);
    refuse(part, "with it, the rotors of its body " + in_quotes(name) + " have " +
                     text(axis.dot(of_rotors * axis)) + " kg m^2 about one axis, the body " +
                     text(axis.dot(J_c * axis)));
  }
  for (const auto& mode : craft.modes) {
    if (mode.body != name) continue;
    Vector6 d;
    d << mode.rotation_b, mode.translation_b;
    left -= d * d.transpose();
    if (!positive(left))
      refuse("mode " + in_quotes(mode.name),
             "with it, more mass takes part in modes than its body " + in_quotes(name) + " has");
  }
}

void check_parts(const PlainSpacecraft& craft) {
  check_names(craft);
  check_mass(in_quotes(craft.hub), craft.mass, craft.r_hc_h, craft.J_c_h);
  if (craft.bodies.empty())
    through(in_quotes(craft.hub),
            [&] { return inertia_from_tensor(in<ThisBody>, craft.J_c_h).inverse_matrix(); });
  std::vector<std::string_view> bodies{craft.hub};
  for (const auto& body : craft.bodies) bodies.push_back(body.name);
  for (const auto& body : craft.bodies) {
    const std::string part = in_quotes(body.name);
    require_body(part, body.parent, bodies);
    check_mass(part, body.mass, body.r_bc_b, body.J_c_b);
    check_joint(part, body);
  }
  for (const auto& rotor : craft.rotors) {
    const std::string part = "rotor " + in_quotes(rotor.name);
    require_body(part, rotor.body, bodies);
    require_axis(part, rotor.axis_b);
    if (!(rotor.inertia > 0.0 && std::isfinite(rotor.inertia)))
      refuse(part, "its inertia is " + text(rotor.inertia) + " kg m^2");
    require_size(part, "its inertia", rotor.inertia, " kg m^2");
  }
  for (const auto& mode : craft.modes) {
    const std::string part = "mode " + in_quotes(mode.name);
    require_body(part, mode.body, bodies);
    require_finite(part, "the participation in rotation", mode.rotation_b);
    require_finite(part, "the participation in translation", mode.translation_b);
    if (!(mode.frequency > 0.0 && std::isfinite(mode.frequency)))
      refuse(part, "its frequency is " + text(mode.frequency) + " rad/s");
    if (!(mode.damping_ratio >= 0.0 && std::isfinite(mode.damping_ratio)))
      refuse(part, "its damping ratio is " + text(mode.damping_ratio));
  }
  check_internals(craft, craft.hub, craft.mass, craft.r_hc_h, craft.J_c_h);
  for (const auto& body : craft.bodies) check_internals(craft, body.name, body.mass, body.r_bc_b, body.J_c_b);
}

}  // namespace

PlainSpacecraft checked_craft(PlainSpacecraft craft, const char* form) {
  try {
    check_parts(craft);
    craft.bodies = in_order(craft);
  } catch (const BadInput& error) {
    throw BadInput(std::string{form} + ": " + error.what());
  }
  return craft;
}

}  // namespace vectrix::detail
