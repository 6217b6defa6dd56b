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

/// Random loads in inertial axes, efforts of hinges and sliders, motors.
struct RandomLoads {
  Vector3d field;
  std::vector<Vector3d> forces, torques;
  std::vector<double> efforts, motors;  // efforts by body

  RandomLoads(Draw& draw, const PlainSpacecraft& craft) : field(draw.triple()) {
    for (std::size_t i = 0; i < craft.bodies.size(); ++i) efforts.push_back(draw.normal());
    for (std::size_t i = 0; i < craft.rotors.size(); ++i) motors.push_back(draw.normal());
    for (std::size_t i = 0; i <= craft.bodies.size(); ++i) {
      forces.push_back(draw.triple());
      torques.push_back(draw.triple());
    }
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
    };
  }
  detail::SimbodyEngine::Loads theirs(const PlainSpacecraft& craft) const {
    return [&](double, const double* y, detail::SimbodyLoads& given) {
      const Matrix3d R_h_from_i =
          Eigen::Quaterniond(y[0], y[1], y[2], y[3]).normalized().toRotationMatrix().transpose();
      const auto three = [](const Vector3d& v) { return std::array{v.x(), v.y(), v.z()}; };
      given = {{}, {}, {}, motors, three(field), {}, std::vector<char>(motors.size(), 0)};
      for (std::size_t b = 0; b < forces.size(); ++b) {
        given.forces.push_back(three(R_h_from_i * forces[b]));
        given.torques.push_back(three(R_h_from_i * torques[b]));
      }
      for (std::size_t b = 0; b < craft.bodies.size(); ++b) {
        const PlainBody& body = craft.bodies[b];
        given.efforts.resize(given.efforts.size() + detail::counts_of(body.joint).speeds);
        if (body.joint == JointKind::hinge || body.joint == JointKind::slider)
          given.efforts.back() = efforts[b];
        given.locked_joints.push_back(body.name.starts_with("locked"));
      }
    };
  }
};

struct Reached {
  double acceleration = 0.0, reaction = 0.0;
};

void compare(Draw& draw, bool locks, Reached& reached) {
  const PlainSpacecraft made = random_craft(draw, locks, 30);
  const RandomLoads loads(draw, made);
  const NamedSpacecraft craft(made);
  std::vector<double> y(craft.state_size());
  for (double& number : y) number = draw.normal();
  for (std::size_t i = 7; i < 13; ++i) y[i] = 0.0;
  std::vector<NamedHeld> held;
  for (const PlainBody& body : made.bodies)
    if (body.name.starts_with("locked")) held.push_back(locked(body.name));
  const auto ours = craft.motion(craft.state(y), 0.0 * si::second, loads.ours(made), held);

  detail::SimbodyEngine simbody(detail::simbody_craft("validation", made), SimbodyPair::merson, 1e-3, 1.0,
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
  for (std::size_t b = 0; b < reactions.size(); ++b) {
    const std::string& name = made.bodies[b].name;
    const auto off = [](const auto& ours_i, const std::array<double, 3>& theirs_i) {
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
