#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/prescribed.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "craft/named_five.hpp"
#include "craft/random_spacecraft.hpp"
#include "load/three_parts.hpp"
#include "methods.hpp"
#include "testing/trials.hpp"

// A load that gives what is not finite is named in the error, with what it acts on.
namespace vectrix_test::not_finite_test {
namespace {

using namespace vectrix;
using namespace vectrix_test::short_units;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_said(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text << "\n  without: " << part;
}

TEST(LoadNotFinite, EveryDoorIsNamedWithItsPart) {
  using namespace vectrix_test::spacecraft_test;
  RandomCraft random(20261203);
  const Every craft(random);
  const auto start = random_state(craft, random);
  const auto fine = spring(craft, of<Boom>, 2.0 * N_m / rad, 0.0 * rad);
  const auto expect = [&](const std::string& what, const auto& put) {
    const auto bad = [&](const Now<Every>&, Forces<Every>& forces) { put(forces); };
    const std::string text = message<BadInput>([&] { (void)motion(craft, start, fine, bad, fine); });
    expect_said(text, ": load 2 of 3: the " + what);
  };
  const std::string boom = frame_name<Boom>(), antenna = frame_name<Antenna>(), hub = frame_name<Hub>();
  const auto lost = nan * N_m * unit_x(in<Gyro>);
  const auto pulled = nan * N * unit_y(in<Hub>);
  const auto r = displacement(of<Gyro>, relative_to<Boom>, vector(in<Boom>, 1.0 * m, 0.0 * m, 0.0 * m));
  using F = Forces<Every>;
  expect("torque on " + boom + " is (nan, nan, nan) N m in the axes of " + hub,
         [&](F& f) { f.torque(of<Boom>, lost); });
  expect("force on " + antenna + " is (nan, nan, nan) N in the axes of " + hub,
         [&](F& f) { f.force(of<spacecraft_test::Camera>, pulled); });
  expect("force on " + boom + " is (nan, nan, nan) N", [&](F& f) { f.force(of<Boom>, r, pulled); });
  expect("force on " + hub + " is (nan, nan, nan) N", [&](F& f) {
    f.wrench(of<Hub>,
             wrench(pulled, torque_about<Hub>(vector<si::torque>(in<Hub>, Eigen::Vector3d::Zero()))));
  });
  expect("effort on the joint of " + boom + " is nan N m", [](F& f) { f.effort(of<Boom>, nan * N_m); });
  expect("effort on the joint of " + frame_name<Mass>() + " is -inf N",
         [](F& f) { f.effort(of<Mass>, -infinity * N); });
  expect("effort 2 on the joint of " + antenna + " is nan N m",
         [](F& f) { f.effort(of<Antenna>, 1.0 * N_m, nan * N_m); });
  expect("effort 1 on the joint of " + frame_name<Gyro>() + " is nan N m",
         [&](F& f) { f.effort(of<Gyro>, lost); });
  expect("effort 1 on the joint of " + frame_name<Probe>() + " is nan N m",
         [&](F& f) { f.effort(of<Probe>, lost); });
  expect("motor torque on " + frame_name<WheelOfHub>() + " is nan N m",
         [](F& f) { f.motor(of<WheelOfHub>, nan * N_m); });
  expect("given acceleration on the joint of " + boom + " is inf rad/s^2",
         [](F& f) { f.drive(of<Boom>, infinity * (rad_s / s)); });
  expect("given acceleration on the joint of " + frame_name<Mass>() + " is nan m/s^2",
         [](F& f) { f.drive(of<Mass>, nan * (m_s / s)); });
  expect("given acceleration 2 on the joint of " + antenna + " is nan rad/s^2",
         [](F& f) { f.drive(of<Antenna>, about_axis<2>, nan * (rad_s / s)); });
  expect("given acceleration on " + frame_name<WheelOfBoom>() + " is nan rad/s^2",
         [](F& f) { f.drive(of<WheelOfBoom>, nan * (rad_s / s)); });
  expect("force on " + frame_name<Blanket>() + " 2 is nan kg^1/2 m/s^2", [](F& f) {
    f.modal(of<Blanket>, {0.0, nan});
  });
  expect("field on the craft is (nan, nan, nan) m/s^2 in the axes of " + frame_name<spacecraft_test::Gcrf>(),
         [](F& f) { f.field(nan * (m_s / s) * unit_x(in<spacecraft_test::Gcrf>)); });

  const auto most = [](const Now<Every>&, F& f) { f.motor(of<WheelOfHub>, 1.5e308 * N_m); };
  expect_said(message<BadInput>([&] { (void)motion(craft, start, most, most); }),
              ": the loads together: the motor torque on " + frame_name<WheelOfHub>() + " is inf N m");
}

// The mechanics is not blamed on a load.
TEST(LoadNotFinite, FiniteLoadsAreNotBlamed) {
  using namespace vectrix_test::three_parts;
  const Sat sat;
  const auto huge = [](const Now<Sat>&, Forces<Sat>& f) { f.effort(of<Panel>, 1e308 * N_m); };
  const std::string text =
      message<BadInput>([&] { (void)motion(sat, start_of(sat, {.rate = 1e200}), huge); });
  expect_said(text, "the derivative of ");
  EXPECT_EQ(text.find("load"), std::string::npos) << text;
}

// In a run, by every method and in both states of the attitude, also of ready loads that call a function.
TEST(LoadNotFinite, ARunNamesTheLoad) {
  using namespace vectrix_test::three_parts;
  const Sat sat;
  const auto late = [](double t, double fine) { return t > 0.6 ? nan : fine; };
  const auto drag = damper(sat, of<Panel>, 0.1 * (N_m / rad_s));
  const auto motor = of_time(sat, of<three_parts::Wheel>,
                             [=](const Quantity<si::time>& t) { return late(t.value(), 0.1) * N_m; });
  const auto fails = [&](const auto& flight, const CraftPropagation& how) {
    return message<std::runtime_error>([&] { (void)propagate(flight, start_of(sat, {.rate = 0.1}), how); });
  };
  for (const ode::Method method : methods) {
    CraftPropagation how = until(1.0, 1e-9);
    how.method = method;
    for (const auto attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
      how.attitude = attitude;
      expect_said(fails(scenario(sat, drag, motor), how),
                  ": load 2 of 2: the motor torque on " + frame_name<three_parts::Wheel>() + " is nan N m");
    }
  }

  struct Command {
    Quantity<si::torque> torque;
  };
  const auto obey = [](const Now<Sat>&, Forces<Sat>& f, const Command& command) {
    f.effort(of<Panel>, command.torque);
  };
  const auto commanded =
      scenario(sat, drag, held(Command{0.1 * N_m}), obey, at_times({0.3 * s}, becomes(Command{nan * N_m})));
  const std::string text = fails(commanded, until(1.0));
  expect_said(text, "at t = 0.3");
  expect_said(text, ": load 2 of 2: the effort on the joint of " + frame_name<Panel>() + " is nan N m");

  // Finite at all times at which the run asks before it starts.
  const auto turned = prescribed(sat, of<Panel>, [](const Quantity<si::time>& t) {
    const double beyond = t.value() > 0.7 && t.value() < 0.701 ? nan : 0.0;
    return JointMotion{0.1 * t.in(s)*rad, 0.1 * rad_s, beyond * (rad_s / s)};
  });
  CraftPropagation fine_steps = until(1.0);
  fine_steps.maximum_step = 0.5e-3 * s;
  expect_said(
      fails(scenario(sat, turned), fine_steps),
      ": load 1 of 1: the given acceleration on the joint of " + frame_name<Panel>() + " is nan rad/s^2");
}

TEST(LoadNotFinite, OfNamesTheDoorIsNamed) {
  using namespace vectrix_test::named_five;
  const NamedSpacecraft craft(five());
  const NamedState start = state_of_five(craft, Matrix3d::Identity());
  const NamedLoads motor = [](const NamedNow& now, NamedForces& forces) {
    forces.motor("wheel", (now.segment_start().value() > 0.4 ? nan : 0.1) * N_m);
  };
  expect_said(message<BadInput>([&] { (void)craft.motion(start, 1.0 * s, motor); }),
              ": the motor torque on wheel is nan N m");
  const auto held = prescribed("mass", [](const Quantity<si::time>&) { return infinity * (m_s / s); });
  expect_said(message<BadInput>([&] { (void)craft.motion(start, 0.0 * s, {}, {held}); }),
              ": the given acceleration on the joint of mass is inf m/s^2");

  const CraftTolerances fine{1e-9 * rad, 1e-9 * rad_s, 1e-6 * m, 1e-6 * m_s, 1e-9};
  ode::Problem problem = craft.problem(start, 0.0 * s, 1.0 * s, 1e-9, fine, motor);
  problem.breakpoints = {0.5};
  expect_said(message<ode::Failure>([&] { (void)ode::solve(problem); }),
              " at t = 0.5: the motor torque on wheel is nan N m");
}

}  // namespace
}  // namespace vectrix_test::not_finite_test
