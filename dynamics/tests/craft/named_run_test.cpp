#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "craft/named_five.hpp"
#include "multibody/random_craft.hpp"

// Runs of a NamedSpacecraft, with loads and held joints.
namespace vectrix_test::named_run_test {
namespace {

using namespace vectrix;
using namespace named_five;

constexpr double tolerance = 1e-12;
const CraftTolerances tight{tolerance * rad, tolerance* rad_s, tolerance* si::metre, tolerance* m_s,
                            tolerance};

TEST(NamedRun, KeepsMomentumOverARun) {
  RandomCraft random(20260323);
  PlainSpacecraft plain = five();
  plain.modes[0].damping_ratio = 0.0;
  const NamedSpacecraft craft(plain);
  const NamedState start = craft.state(at_origin(craft.inertial(), craft.hub(), random.rotation()),
                                       starts_of_five(craft, random.rotation()));
  auto problem = craft.problem(start, 0.0 * si::second, 5.0 * si::second, tolerance, tight);
  problem.method = ode::Method::arkode_fehlberg_8;
  const auto solution = ode::solve(problem);
  // Each step changes each number y by tolerance (1 + |y|), and what is made of numbers near 1 by as much.
  const double kept = 2.0 * tolerance * static_cast<double>(solution.statistics().steps);
  const auto first = craft.motion(start, 0.0 * si::second);
  const auto last = craft.motion(craft.state(solution.at(5.0)), 5.0 * si::second);
  const auto relative = [&](auto what) {
    const auto before = what(first.now()), after = what(last.now());
    return (after - before).norm() / before.norm();
  };
  EXPECT_LE(relative([](const auto& now) { return now.momentum().coordinates(); }), kept);
  EXPECT_LE(relative([](const auto& now) { return now.angular_momentum().coordinates(); }), kept);
  EXPECT_NEAR(last.now().energy() / first.now().energy(), 1.0, kept);
}

// 2 kg m^2 about z.
NamedSpacecraft turning_hub() {
  return NamedSpacecraft({"gcrf",
                          "hub",
                          HubMotion::turning,
                          1.0,
                          Vector3d::Zero(),
                          Vector3d(1.0, 2.0, 2.0).asDiagonal(),
                          {},
                          {},
                          {}});
}
NamedState about_z(const NamedSpacecraft& craft, double rate) {
  const NamedFrame i = craft.inertial(), hub = craft.hub();
  const auto w_ih_h = vector<si::angular_velocity>(In(hub), Vector3d(0.0, 0.0, rate));
  return craft.state(moving_dcm(aligned(To(i), From(hub)), angular_velocity(Of(hub), RelativeTo(i), w_ih_h)),
                     {});
}

// A hub of inertia J alone, with a torque that acts from 1 s to 3 s: w = M t / J, exactly: the
// method integrates a constant without an error, so only its steps, of which there are some ten, are rounded.
TEST(NamedRun, ALoadJumpsAtABreakpoint) {
  const NamedSpacecraft craft = turning_hub();
  const NamedFrame hub = craft.hub();
  const NamedState start = about_z(craft, 0.0);
  auto run = craft.problem(
      start, 0.0 * si::second, 4.0 * si::second, 1e-12, tight, [&](const NamedNow& now, NamedForces& forces) {
        if (now.segment_start() >= 1.0 * si::second && now.segment_start() < 3.0 * si::second)
          forces.torque(hub, vector<si::torque>(In(hub), Vector3d(0.0, 0.0, 0.4)));
      });
  run.method = ode::Method::verner_9;
  run.breakpoints = {1.0, 3.0};
  const auto solution = ode::solve(run);
  const auto rate = [&](double t) {
    return Vector3d(craft.state(solution.at(t)).turning().angular_velocity().coordinates());
  };
  // A step adds a sum of sixteen products, of at most the final rate: 16 roundings.
  const double rounded = 16.0 * static_cast<double>(solution.statistics().steps) * epsilon * 0.4;
  EXPECT_EQ(rate(1.0).norm(), 0.0);
  EXPECT_NEAR(rate(2.0).z(), 0.2, rounded);
  EXPECT_NEAR(rate(4.0).z(), 0.4, rounded);
}

// Of a rate w about z, with J = 2 kg m^2: a torque -k w_n for a period T makes w_n+1 = w_n (1 - k T / J).
TEST(NamedRun, AControllerSamplesAtTheStartOfEachSegment) {
  const NamedSpacecraft craft = turning_hub();
  const NamedFrame hub = craft.hub();
  const NamedState start = about_z(craft, 0.1);
  Vector3d command = Vector3d::Zero();  // N m, held between two samples
  const NamedLoads motors = [&](const NamedNow&, NamedForces& forces) {
    forces.torque(hub, vector<si::torque>(In(hub), command));
  };
  auto run = craft.problem(start, 0.0 * si::second, 4.0 * si::second, tolerance, tight, motors);
  for (int k = 1; k < 8; ++k) run.breakpoints.push_back(0.5 * k);
  run.at_segment_start = [&](double, std::span<double> y, std::span<const ode::Event>) {
    const NamedState now = craft.state(std::span<const double>(y));
    command = -0.8 * now.turning().angular_velocity().coordinates();
  };
  const auto solution = ode::solve(run);
  // A step adds sums of at most sixteen products of numbers below 0.1, and changes them by the tolerance.
  const double rounded = static_cast<double>(solution.statistics().steps) * (tolerance + 16.0 * epsilon);
  const auto rate = craft.state(solution.at(4.0)).turning().angular_velocity();
  EXPECT_NEAR(rate.coordinates().z(), 0.1 * std::pow(1.0 - 0.8 * 0.5 / 2.0, 8), rounded);
}

TEST(NamedRun, HeldJointsMoveAsTheyAreTold) {
  RandomCraft random(20260324);
  const NamedSpacecraft craft(five());
  const NamedState start = state_of_five(craft, random.rotation());
  const std::vector<NamedHeld> held{
      prescribed("boom",
                 [](const Quantity<si::time>& t) { return 0.2 * t / si::second * (rad_s / si::second); }),
      prescribed("mass", [](const Quantity<si::time>&) { return -0.1 * (m_s / si::second); }),
      locked("gyro")};
  auto problem = craft.problem(start, 0.0 * si::second, 2.0 * si::second, 1e-11, tight, {}, held);
  problem.method = ode::Method::arkode_fehlberg_8;
  const auto solution = ode::solve(problem);
  const NamedState end = craft.state(solution.at(2.0));
  // The method integrates a cubic without an error: a step adds a sum of thirteen products, of at most 3.
  const double rounded = 13.0 * static_cast<double>(solution.statistics().steps) * epsilon * 3.0;
  EXPECT_NEAR(end.angle("boom").value(), 0.5 + 0.6 * 2.0 + 0.2 * 8.0 / 6.0, rounded);
  EXPECT_NEAR(end.length("mass").value(), 0.7 + 0.8 * 2.0 - 0.1 * 4.0 / 2.0, rounded);
  const auto said = [&](const NamedHeld& wrong) {
    return message<BadInput>([&] { (void)craft.motion(start, 0.0 * si::second, {}, {wrong}); });
  };
  EXPECT_TRUE(contains(said(locked("bom")), "the nearest name is \"boom\""));
  EXPECT_TRUE(
      contains(said(prescribed("boom", [](const Quantity<si::time>&) { return 0.0 * (m_s / si::second); })),
               "its joint is a hinge, and the acceleration that of a slider"));
}

}  // namespace
}  // namespace vectrix_test::named_run_test
