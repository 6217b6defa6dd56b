#include <limits>

#include "rigid_bodies.hpp"

// The parts of a scenario, and what propagate() refuses.
namespace vectrix::test::scenario_test {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

BodyScenario body() {
  return AxisymmetricBody{}.scenario();
}

auto orbit() {
  return body_orbit({7e6, 0.0, 0.0}, {0.0, 7500.0, 0.0});
}

Quantity<si::gravitational_parameter> mu(double value = 3.986004418e14) {
  return Quantity<si::gravitational_parameter>::from_value(value);
}

CustomTorque<Gcrf, Body> constant(double x) {
  return {[x](const BodyState&) { return torque_body(x, 0.0, 0.0); }};
}

Vector3d torque_at(const BodyScenario& scenario, double t) {
  return torque(scenario, state_at(t, Quaterniond::Identity(), Vector3d::Zero())).coordinates();
}

TEST(ScenarioTorque, a_pulse_acts_from_its_start_to_before_its_stop) {
  BodyScenario scenario = body();
  scenario.pulses = {{seconds(1.0), seconds(2.0), torque_body(1.0, 2.0, 3.0)},
                     {seconds(1.5), seconds(3.0), torque_body(10.0, 0.0, 0.0)}};
  EXPECT_EQ(torque_at(scenario, std::nextafter(1.0, 0.0)), Vector3d::Zero());
  EXPECT_EQ(torque_at(scenario, 1.0), Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(torque_at(scenario, 1.5), Vector3d(11.0, 2.0, 3.0));
  EXPECT_EQ(torque_at(scenario, 2.0), Vector3d(10.0, 0.0, 0.0));
  EXPECT_EQ(torque_at(scenario, 3.0), Vector3d::Zero());
}

TEST(ScenarioTorque, inside_a_piece_the_start_of_the_piece_decides) {
  BodyScenario scenario = body();
  scenario.pulses = {{seconds(1.0), seconds(2.0), torque_body(1.0, 0.0, 0.0)}};
  const BodyState at_two = state_at(2.0, Quaterniond::Identity(), Vector3d::Zero());
  EXPECT_EQ(torque(scenario, at_two, seconds(1.0)).coordinates(), Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(torque(scenario, at_two, seconds(2.0)).coordinates(), Vector3d::Zero());
}

TEST(ScenarioTorque, a_custom_torque_is_asked_inside_the_piece) {
  for (const bool right_continuous : {true, false}) {
    BodyScenario scenario = body();
    scenario.torques = {{[=](const BodyState& state) {
                           const double t = state.time.value();
                           return torque_body((right_continuous ? t < 2.0 : t <= 2.0) ? 1.0 : -1.0, 0.0, 0.0);
                         },
                         {seconds(5.0), seconds(2.0)}}};
    const BodyState at_two = state_at(2.0, Quaterniond::Identity(), Vector3d::Zero());
    EXPECT_EQ(torque(scenario, at_two, seconds(0.0)).coordinates().x(), 1.0);
    EXPECT_EQ(torque(scenario, at_two, seconds(2.0)).coordinates().x(), -1.0);
  }
}

TEST(ScenarioTorque, is_the_sum_of_all) {
  BodyScenario scenario = body();
  EXPECT_TRUE(scenario.torque_free());
  scenario.initial.orbit = orbit();
  scenario.mu = mu();
  EXPECT_TRUE(scenario.torque_free());
  scenario.gravity_gradient = true;
  EXPECT_FALSE(scenario.torque_free());
  scenario.torques = {constant(1.0), constant(20.0)};
  scenario.pulses = {{seconds(0.0), seconds(2.0), torque_body(300.0, 0.0, 0.0)}};
  const Vector<Body, si::length> r_b = inverse(scenario.initial.R_i_from_b()) * orbit().position.vector();
  const Vector3d gradient = gravity_gradient_torque(mu(), scenario.inertia, r_b).coordinates();
  EXPECT_GT(gradient.norm(), 0.0);
  EXPECT_LT((torque(scenario, scenario.initial).coordinates() - gradient - Vector3d(321.0, 0.0, 0.0)).norm(),
            1e-12);
}

// g++ 12 failed on these with an internal error.
TEST(ScenarioTorque, may_be_written_in_the_braces_of_its_scenario) {
  const auto spring = [](const BodyState& state) { return torque_body(state.time.value(), 0.0, 0.0); };
  const std::vector<BodyScenario> scenarios = {
      {.inertia = body().inertia, .initial = body().initial, .torques = {{spring}}},
      {.inertia = body().inertia, .initial = body().initial}};
  EXPECT_EQ(torque_at(scenarios[0], 3.0), Vector3d(3.0, 0.0, 0.0));
  EXPECT_TRUE(scenarios[0].torques[0].discontinuities.empty());
  EXPECT_TRUE(scenarios[1].torque_free());
  const std::vector<BodyPropagation> propagations = {{.end = seconds(1.0)}};
  EXPECT_TRUE(propagations[0].output_times.empty() && propagations[0].roots.empty());
}

TEST(ScenarioTorque, a_gradient_without_orbit_is_refused) {
  BodyScenario scenario = body();
  scenario.gravity_gradient = true;
  expect_bad_input([&] { torque(scenario, scenario.initial); },
                   "the gravity-gradient torque needs mu and an orbit");
}

TEST(ScenarioMomentum, is_turned_into_the_inertial_frame) {
  const AxisymmetricBody exact;  // its angular momentum is fixed in space
  const Vector3d at_start = angular_momentum(exact.scenario(), exact.exact(0.0)).coordinates();
  const Vector3d later = angular_momentum(exact.scenario(), exact.exact(7.0)).coordinates();
  EXPECT_LT((later - at_start).norm(), 1e-14 * 10.0);
  EXPECT_NEAR(at_start.norm(), Vector3d(0.6, -0.4, 1.5).norm(), 1e-14);
}

/// Expects that propagate() refuses body() after `change`, with `text` in the message.
template <class Change> void expect_refused_scenario(const Change& change, const std::string& text) {
  BodyScenario scenario = body();
  change(scenario);
  expect_bad_input([&] { propagate(scenario, BodyPropagation{.end = seconds(1.0)}); },
                   "Scenario of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>() + ": " + text);
}

TEST(RefusedScenario, what_is_missing_or_not_a_number) {
  expect_refused_scenario([](auto& s) { s.initial.time = seconds(nan); }, "the initial time is nan s");
  expect_refused_scenario([](auto& s) { s.initial.orbit = orbit(); },
                          "the initial state has an orbit, but mu is not given");
  expect_refused_scenario([](auto& s) { s.mu = mu(0.0); }, "mu is 0 m^3/s^2");
  expect_refused_scenario([](auto& s) { s.mu = mu(-1.0); }, "mu is -1 m^3/s^2");
  expect_refused_scenario([](auto& s) { s.mu = mu(infinity); }, "mu is inf m^3/s^2");
  expect_refused_scenario(
      [](auto& s) {
        s.mu = mu();
        s.gravity_gradient = true;
      },
      "the gravity-gradient torque needs an orbit in the initial state");
  expect_refused_scenario(
      [](auto& s) {
        const auto unit = si::kilogram_square_metre;
        s.inertia = inertia_from_principal_moments(in<Body>, 0.0 * unit, 4.0 * unit, 4.0 * unit);  // a rod
      },
      "Euler's equation needs the inverse of the inertia [0 0 0; 0 4 0; 0 0 4] kg m^2");
  expect_refused_scenario([](auto& s) { s.torques = {CustomTorque<Gcrf, Body>{}}; },
                          "a custom torque has no function");
  expect_refused_scenario(
      [](auto& s) {
        s.torques = {constant(1.0)};
        s.torques[0].discontinuities = {seconds(1.0), seconds(infinity)};
      },
      "a discontinuity of a custom torque is at inf s");
}

TEST(RefusedScenario, a_pulse_that_does_not_last) {
  const auto with_pulse = [](double start, double stop) {
    return [=](BodyScenario& s) { s.pulses = {{seconds(start), seconds(stop), torque_body(1.0, 0.0, 0.0)}}; };
  };
  expect_refused_scenario(with_pulse(2.0, 1.0), "a pulse from 2 s to 1 s does not last");
  expect_refused_scenario(with_pulse(2.0, 2.0), "a pulse from 2 s to 2 s does not last");
  expect_refused_scenario(with_pulse(nan, 1.0), "a pulse from nan s to 1 s does not last");
  expect_refused_scenario(with_pulse(0.0, infinity), "a pulse from 0 s to inf s does not last");
}

/// Expects that propagate() refuses one second of body() after `change` of the settings, with `text` in the
/// message.
template <class Change> void expect_refused_propagation(const Change& change, const std::string& text) {
  BodyPropagation how{.end = seconds(1.0)};
  change(how);
  expect_bad_input([&] { propagate(body(), how); }, text);
}

TEST(RefusedPropagation, tolerances_that_are_not_positive) {
  const auto text = [](const std::string& name, const std::string& value) {
    return "propagate: the tolerance " + name + " is " + value + "; it must be positive";
  };
  const auto per_second = [](double value) { return Quantity<si::angular_velocity>::from_value(value); };
  expect_refused_propagation([](auto& how) { how.tolerances.relative = 0.0; }, text("relative", "0"));
  expect_refused_propagation([](auto& how) { how.tolerances.attitude = -1e-12; }, text("attitude", "-1e-12"));
  expect_refused_propagation([&](auto& how) { how.tolerances.rate = per_second(nan); }, text("rate", "nan"));
  expect_refused_propagation([](auto& how) { how.tolerances.position = infinity * si::metre; },
                             text("position", "inf"));
  expect_refused_propagation([](auto& how) { how.tolerances.velocity = 0.0 * (si::metre / si::second); },
                             text("velocity", "0"));
}

TEST(RefusedPropagation, times_that_make_no_sense) {
  expect_refused_propagation([](auto& how) { how.end = seconds(nan); },
                             "propagate: end must be finite, got nan");
  expect_refused_propagation([](auto& how) { how.end = seconds(infinity); }, "end must be finite, got inf");
  expect_refused_propagation([](auto& how) { how.end = seconds(-1.0); },
                             "end = -1 must be later than start = 0");
  expect_refused_propagation([](auto& how) { how.end = seconds(0.0); },
                             "end = 0 must be later than start = 0");
  expect_refused_propagation(
      [](auto& how) {
        how.output_times = {seconds(0.5), seconds(0.5)};
      },
      "output times must increase strictly, but number 1 = 0.5 follows 0.5");
  expect_refused_propagation(
      [](auto& how) {
        how.output_times = {seconds(0.5), seconds(1.5)};
      },
      "propagate: output time 1.5 is outside [0, 1]");
  expect_refused_propagation([](auto& how) { how.maximum_step = seconds(0.0); },
                             "maximum_step must be greater than 0, got 0");
  expect_refused_propagation([](auto& how) { how.max_steps = 0; }, "max_steps must be greater than 0");
}

TEST(RefusedPropagation, a_root_without_function) {
  expect_refused_propagation([](auto& how) { how.roots = {{.name = "eclipse", .function = {}}}; },
                             "propagate: the root \"eclipse\" has no function");
}

}  // namespace
}  // namespace vectrix::test::scenario_test
