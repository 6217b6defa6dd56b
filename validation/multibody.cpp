#include <array>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/simbody.hpp>

#include "comparison.hpp"
#include "random_craft.hpp"

// Accelerations and joint reactions of random crafts, in random motion and under random loads, compared with
// Simbody. The hub's velocity and position are zero: Simbody loses digits to them.
namespace vectrix::validation {
namespace {

/// Thirty bodies on each other: the condition of their joints times the rounding of both engines.
constexpr double acceleration_tolerance = 1e-11;
/// A reaction is a difference of larger forces.
constexpr double reaction_tolerance = 1e-10;
constexpr const char* rounding_of_both = "rounding of both, for up to 30 bodies on each other";

/// Whether a joint that is not free to move has an acceleration of its own: each that has axes, if the craft
/// is flexible. All others are locked.
bool is_driven(const PlainSpacecraft& craft, const PlainBody& body) {
  return !craft.modes.empty() && body.name.starts_with("locked") && !body.axes_b.empty();
}

/// Random loads in inertial axes, efforts of hinges and sliders, motors, forces on modes; accelerations of
/// driven joints.
struct RandomLoads {
  Vector3d field;
  std::vector<Vector3d> forces, torques;
  std::vector<double> efforts, motors, modal;  // efforts by body
  std::vector<std::array<double, 2>> driven;   // by body

  RandomLoads(Draw& draw, const PlainSpacecraft& craft) : field(draw.triple()) {
    for (std::size_t i = 0; i < craft.bodies.size(); ++i) efforts.push_back(draw.normal());
    for (std::size_t i = 0; i < craft.rotors.size(); ++i) motors.push_back(draw.normal());
    for (std::size_t i = 0; i <= craft.bodies.size(); ++i) {
      forces.push_back(draw.triple());
      torques.push_back(draw.triple());
    }
    for (std::size_t i = 0; i < craft.modes.size(); ++i) modal.push_back(draw.normal());
    for (std::size_t i = 0; i < craft.bodies.size(); ++i)
      driven.push_back(craft.modes.empty() ? std::array{0.0, 0.0} : std::array{draw.normal(), draw.normal()});
  }

  std::vector<NamedHeld> held(const PlainSpacecraft& craft) const {
    const auto rad_s2 = si::radian / si::second / si::second;
    std::vector<NamedHeld> list;
    for (std::size_t b = 0; b < craft.bodies.size(); ++b) {
      const PlainBody& body = craft.bodies[b];
      const auto [first, second] = driven[b];
      if (!body.name.starts_with("locked")) continue;
      if (!is_driven(craft, body))
        list.push_back(locked(body.name));
      else if (body.joint == JointKind::slider)
        list.push_back(
            prescribed(body.name, [a = first * (si::metre / si::second / si::second)](auto) { return a; }));
      else if (body.joint == JointKind::hinge)
        list.push_back(prescribed(body.name, [a = first * rad_s2](auto) { return a; }));
      else
        list.push_back(
            prescribed(body.name, [a = std::array{first * rad_s2, second * rad_s2}](auto) { return a; }));
    }
    return list;
  }

  NamedLoads ours(const PlainSpacecraft& craft) const {
    return [&](const NamedNow& now, NamedForces& given) {
      const NamedFrame i = now.frame(craft.inertial);
      given.field(vector<si::acceleration>(In(i), field));
      for (std::size_t b = 0; b <= craft.bodies.size(); ++b) {
        const NamedFrame body = now.frame(b == 0 ? craft.hub : craft.bodies[b - 1].name);
        given.force(body, vector<si::force>(In(i), forces[b]));
        given.torque(body, vector<si::torque>(In(i), torques[b]));
      }
      for (std::size_t b = 0; b < craft.bodies.size(); ++b) {
        const PlainBody& body = craft.bodies[b];
        if (body.joint == JointKind::hinge) given.effort(body.name, efforts[b] * si::newton_metre);
        if (body.joint == JointKind::slider) given.effort(body.name, efforts[b] * si::newton);
      }
      for (std::size_t r = 0; r < craft.rotors.size(); ++r)
        given.motor(craft.rotors[r].name, motors[r] * si::newton_metre);
      for (std::size_t k = 0; k < craft.modes.size(); ++k) given.modal(craft.modes[k].name, modal[k]);
    };
  }
  detail::SimbodyEngine::Loads theirs(const PlainSpacecraft& craft) const {
    return [&](double, const double* y, detail::SimbodyLoads& given) {
      const Matrix3d R_h_from_i =
          Eigen::Quaterniond(y[0], y[1], y[2], y[3]).normalized().toRotationMatrix().transpose();
      const auto three = [](const Vector3d& v) { return std::array{v.x(), v.y(), v.z()}; };
      given = {};
      given.motors = motors;
      given.modal = modal;
      given.field_i = three(field);
      given.locked_rotors.resize(motors.size());
      given.driven_rotors.resize(motors.size());
      given.given_spins.resize(motors.size());
      const auto act_on = [&](const Vector3d& force, const Vector3d& torque) {
        given.forces.push_back(three(R_h_from_i * force));
        given.torques.push_back(three(R_h_from_i * torque));
      };
      act_on(forces[0], torques[0]);
      for (std::size_t b = 0; b < craft.bodies.size(); ++b) {
        const PlainBody& body = craft.bodies[b];
        const detail::JointCounts counts = detail::counts_of(body.joint);
        const bool is_held = body.name.starts_with("locked"), drives = is_driven(craft, body);
        if (counts.links == 2) act_on(Vector3d::Zero(), Vector3d::Zero());
        act_on(forces[b + 1], torques[b + 1]);
        for (std::size_t i = 0; i < counts.links; ++i) {
          given.locked_links.push_back(is_held && !drives);
          given.driven_links.push_back(drives);
        }
        for (std::size_t i = 0; i < counts.speeds; ++i) given.given.push_back(drives ? driven[b][i] : 0.0);
        given.efforts.resize(given.efforts.size() + counts.speeds);
        if (body.joint == JointKind::hinge || body.joint == JointKind::slider)
          given.efforts.back() = efforts[b];
      }
    };
  }
};

struct Reached {
  double acceleration = 0.0, reaction = 0.0;
};

void compare(Draw& draw, bool locks, bool flexible, Reached& reached) {
  const PlainSpacecraft made = random_craft(draw, locks, 30, flexible);
  const RandomLoads loads(draw, made);
  const NamedSpacecraft craft(made);
  std::vector<double> y(craft.state_size());
  for (double& number : y) number = draw.normal();
  make_small(made, y);
  for (std::size_t i = 7; i < 13; ++i) y[i] = 0.0;
  const auto ours = craft.motion(craft.state(y), 0.0 * si::second, loads.ours(made), loads.held(made));

  detail::SimbodyEngine simbody(detail::simbody_craft(made), SimbodyPair::merson, 1e-3, 1.0,
                                loads.theirs(made));
  std::vector<double> theirs(y.size());
  simbody.rates(0.0, y.data(), theirs.data());
  double largest = 1.0, difference = 0.0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      largest = detail::larger(largest, std::abs(theirs[i]));
      difference = detail::larger(difference, std::abs(theirs[i] - ours.rates()[i]));
    }
  };
  add(4, 7);
  add(10, 13);
  std::size_t speeds = 13;
  for (const PlainBody& body : made.bodies) speeds += detail::counts_of(body.joint).positions;
  add(speeds, y.size());
  reached.acceleration = detail::larger(reached.acceleration, difference / largest);

  const auto reactions = simbody.reactions();
  std::size_t link = 0;
  for (const PlainBody& body : made.bodies) {
    link += detail::counts_of(body.joint).links;
    const auto& reaction = reactions[link - 1];
    const std::string& name = body.name;
    const auto off = [](const auto& ours_i, const std::array<double, 3>& theirs_i) {
      const Vector3d other(theirs_i[0], theirs_i[1], theirs_i[2]);
      return (ours_i.coordinates() - other).norm() / (1.0 + other.norm());
    };
    reached.reaction =
        detail::larger(reached.reaction, off(ours.joint_force(Of(name), In("inertial")), reaction.force_i));
    reached.reaction =
        detail::larger(reached.reaction, off(ours.joint_torque(Of(name), In("inertial")), reaction.torque_i));
  }
}

}  // namespace

Rows multibody_rows(const std::string&) {
  Rows rows;
  const auto report = [&](const std::string& what, int count, bool locks, unsigned long seed,
                          bool flexible = false) {
    Draw draw(seed);
    Reached reached;
    for (int i = 0; i < count; ++i) compare(draw, locks, flexible, reached);
    const std::string scenario =
        std::to_string(count) + " random crafts of 2 to 30 bodies, all kinds of joints, " + what;
    rows.push_back({"Simbody, trees of bodies", scenario, "accelerations, relative to the largest",
                    acceleration_tolerance, "", rounding_of_both, reached.acceleration});
    rows.push_back({"Simbody, trees of bodies", scenario, "what each joint transmits, relative",
                    reaction_tolerance, "", "a difference of larger forces", reached.reaction});
  };
  report("two rotors, random motion and loads", 1000, false, 20260401);
  report("a third of the joints locked in motion", 300, true, 20260402);
  report("slanted gimbals, three modes, a third of the joints driven or locked", 300, true, 20260404, true);
  return rows;
}

}  // namespace vectrix::validation
