#include <random>
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/frames/scalar/larger.hpp>

#include "comparison.hpp"
#include "simbody_reference_tree.hpp"

// Accelerations and joint reactions of random crafts, in random motion and under random loads, compared with
// Simbody. The hub's velocity and position are zero: Simbody loses digits to them.
namespace vectrix::validation {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Thirty bodies on each other: the condition of their joints times the rounding of both engines.
constexpr double acceleration_tolerance = 1e-11;
/// A reaction is a difference of larger forces.
constexpr double reaction_tolerance = 1e-10;
constexpr const char* rounding_of_both = "rounding of both, for up to 30 bodies on each other";

Vector3 plain(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
Matrix3 plain(const Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

class Draw {
 public:
  explicit Draw(unsigned long seed) : random_(seed) {}
  double normal() { return normal_(random_); }
  double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  Vector3d triple() { return {normal(), normal(), normal()}; }
  Matrix3d rotation() {
    return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized().toRotationMatrix();
  }
  /// Of a box, about its centre, in other axes.
  Matrix3d inertia(double mass) {
    const Vector3d squares = Vector3d(between(0.1, 1.0), between(0.1, 1.0), between(0.1, 1.0)).cwiseAbs2();
    const Vector3d principal = mass / 3.0 * (Vector3d::Constant(squares.sum()) - squares);
    const Matrix3d axes = rotation(), J = axes * principal.asDiagonal() * axes.transpose();
    return 0.5 * (J + J.transpose());
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

PlainBody random_body(Draw& draw, int number, const std::string& parent, bool locks) {
  const auto joint = JointKind(draw.below(6));
  const Vector3d first = draw.triple().normalized(), second = first.cross(draw.triple()).normalized();
  std::vector<Vector3d> axes;
  if (joint == JointKind::hinge || joint == JointKind::slider || joint == JointKind::gimbal)
    axes.push_back(first);
  if (joint == JointKind::gimbal) axes.push_back(second);
  const double mass = draw.between(0.3, 3.0);
  return {(locks && draw.below(3) == 0 ? "locked " : "body ") + std::to_string(number),
          parent,
          joint,
          axes,
          draw.rotation(),
          draw.triple(),
          mass,
          0.3 * draw.triple(),
          draw.inertia(mass)};
}

struct Random {
  PlainSpacecraft craft;
  std::vector<int> parents;  // -1: the hub
};

Random random_craft(Draw& draw, bool locks) {
  const double mass = draw.between(3.0, 30.0);
  Random made{{"inertial", "hub", HubMotion::free, mass, 0.3 * draw.triple(), draw.inertia(mass), {}, {}, {}},
              {}};
  auto& bodies = made.craft.bodies;
  const int count = 1 + draw.below(29);
  for (int i = 1; i <= count; ++i) {
    const int parent = draw.below(i);
    bodies.push_back(
        random_body(draw, i, parent == 0 ? "hub" : bodies[static_cast<std::size_t>(parent) - 1].name, locks));
    made.parents.push_back(parent - 1);
  }
  for (int i = 0; i < 2; ++i) {
    const int at = draw.below(count + 1);
    const Matrix3d& J = at == 0 ? made.craft.J_c_h : bodies[static_cast<std::size_t>(at) - 1].J_c_b;
    made.craft.rotors.push_back({"rotor " + std::to_string(i),
                                 at == 0 ? "hub" : bodies[static_cast<std::size_t>(at) - 1].name,
                                 draw.triple().normalized(), 0.05 / J.inverse().trace()});
  }
  return made;
}

SimbodyTreeCraft simbody_craft(const Random& made, Draw& draw) {
  const PlainSpacecraft& craft = made.craft;
  SimbodyTreeCraft theirs{
      craft.mass, plain(craft.r_hc_h), plain(craft.J_c_h), {}, {}, plain(draw.triple()), {}, {}};
  const Vector3d none = Vector3d::Zero();
  for (std::size_t i = 0; i < craft.bodies.size(); ++i) {
    const PlainBody& b = craft.bodies[i];
    theirs.bodies.push_back({SimbodyJoint(static_cast<int>(b.joint)), made.parents[i], plain(b.R_p_from_b),
                             plain(b.r_pb_p), plain(b.axes_b.empty() ? none : b.axes_b.front()),
                             plain(b.axes_b.empty() ? none : b.axes_b.back()), b.mass, plain(b.r_bc_b),
                             plain(b.J_c_b), b.name.starts_with("locked"), draw.normal()});
  }
  for (const PlainRotor& rotor : craft.rotors) {
    int body = -1;
    for (std::size_t i = 0; i < craft.bodies.size(); ++i)
      if (craft.bodies[i].name == rotor.body) body = static_cast<int>(i);
    theirs.rotors.push_back({body, plain(rotor.axis_b), rotor.inertia, draw.normal()});
  }
  for (std::size_t i = 0; i <= craft.bodies.size(); ++i) {
    theirs.force_i.push_back(plain(draw.triple()));
    theirs.torque_i.push_back(plain(draw.triple()));
  }
  return theirs;
}

NamedLoads loads_of(const PlainSpacecraft& craft, const SimbodyTreeCraft& theirs) {
  return [&](const NamedNow& now, NamedForces& forces) {
    const NamedFrame i = now.frame(craft.inertial);
    const auto in_i = [&](const Vector3& v) { return Vector3d(v[0], v[1], v[2]); };
    forces.field(vector<si::acceleration>(In(i), in_i(theirs.field_i)));
    for (std::size_t b = 0; b <= craft.bodies.size(); ++b) {
      const NamedFrame body = now.frame(b == 0 ? craft.hub : craft.bodies[b - 1].name);
      forces.force(body, vector<si::force>(In(i), in_i(theirs.force_i[b])));
      forces.torque(body, vector<si::torque>(In(i), in_i(theirs.torque_i[b])));
    }
    for (std::size_t b = 0; b < craft.bodies.size(); ++b) {
      const PlainBody& body = craft.bodies[b];
      if (body.joint == JointKind::hinge)
        forces.effort(body.name, theirs.bodies[b].effort * si::newton_metre);
      if (body.joint == JointKind::slider) forces.effort(body.name, theirs.bodies[b].effort * si::newton);
    }
    for (std::size_t r = 0; r < craft.rotors.size(); ++r)
      forces.motor(craft.rotors[r].name, theirs.rotors[r].torque_nm * si::newton_metre);
  };
}

struct Reached {
  double acceleration = 0.0, reaction = 0.0;
};

void compare(Draw& draw, bool locks, Reached& reached) {
  const Random made = random_craft(draw, locks);
  const SimbodyTreeCraft theirs = simbody_craft(made, draw);
  const NamedSpacecraft craft(made.craft);
  std::vector<double> y(craft.state_size());
  for (double& number : y) number = draw.normal();
  for (std::size_t i = 7; i < 13; ++i) y[i] = 0.0;
  std::vector<NamedHeld> held;
  for (const PlainBody& body : made.craft.bodies)
    if (body.name.starts_with("locked")) held.push_back(locked(body.name));
  const auto ours = craft.motion(craft.state(y), 0.0 * si::second, loads_of(made.craft, theirs), held);

  SimbodyTree simbody(theirs);
  simbody.evaluate(y.data());
  const std::vector<double> rates = simbody.rates();
  // Ours: alpha at 4, a_i at 10, and the speeds of joints and rotors at the end.
  std::vector<double> same{ours.rates()[4], ours.rates()[5], ours.rates()[6]};
  same.insert(same.end(), ours.rates().begin() + 10, ours.rates().begin() + 13);
  same.insert(same.end(), ours.rates().end() - static_cast<std::ptrdiff_t>(rates.size() - 6),
              ours.rates().end());
  double largest = 1.0, difference = 0.0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    largest = detail::larger(largest, std::abs(rates[i]));
    difference = detail::larger(difference, std::abs(rates[i] - same[i]));
  }
  reached.acceleration = detail::larger(reached.acceleration, difference / largest);

  const auto reactions = simbody.reactions();
  for (std::size_t b = 0; b < reactions.size(); ++b) {
    const std::string& name = made.craft.bodies[b].name;
    const auto off = [](const auto& ours_i, const Vector3& theirs_i) {
      const Vector3d other(theirs_i[0], theirs_i[1], theirs_i[2]);
      return (ours_i.coordinates() - other).norm() / (1.0 + other.norm());
    };
    reached.reaction = detail::larger(reached.reaction,
                                      off(ours.joint_force(Of(name), In("inertial")), reactions[b].force_i));
    reached.reaction = detail::larger(
        reached.reaction, off(ours.joint_torque(Of(name), In("inertial")), reactions[b].torque_i));
  }
}

}  // namespace

Rows multibody_rows(const std::string&) {
  Rows rows;
  const auto report = [&](const std::string& what, int count, bool locks, unsigned long seed) {
    Draw draw(seed);
    Reached reached;
    for (int i = 0; i < count; ++i) compare(draw, locks, reached);
    const std::string scenario =
        std::to_string(count) + " random crafts of 2 to 30 bodies, all kinds of joints, " + what;
    rows.push_back({"Simbody, trees of bodies", scenario, "accelerations, relative to the largest",
                    acceleration_tolerance, "", rounding_of_both, reached.acceleration});
    rows.push_back({"Simbody, trees of bodies", scenario, "what each joint transmits, relative",
                    reaction_tolerance, "", "a difference of larger forces", reached.reaction});
  };
  report("two rotors, random motion and loads", 1000, false, 20260401);
  report("a third of the joints locked in motion", 300, true, 20260402);
  return rows;
}

}  // namespace vectrix::validation
