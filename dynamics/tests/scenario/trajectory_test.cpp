#include <limits>
#include <numbers>
#include <vectrix/dynamics/scenario/conservation.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/motion_laws.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>

#include "rigid_bodies.hpp"

// The results of propagate(): the trajectory, its events, its conservation report, or a failure.
namespace vectrix::test::trajectory_test {
namespace {

using BodyTrajectory = Trajectory<Gcrf, Body>;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
constexpr double accuracy = 1e-9;  // of a Fehlberg 7(8) run of some tens of radians at the default tolerances

struct Camera : moving_frame {};

const AxisymmetricBody body;

BodyPropagation until(double end) {
  return {.end = seconds(end)};
}

// A trajectory cannot be changed: it returns copies.
static_assert(!std::is_default_constructible_v<BodyTrajectory>);
static_assert(std::is_copy_constructible_v<BodyTrajectory>);
static_assert(std::same_as<decltype(std::declval<BodyTrajectory&>().statistics()), ode::Statistics>);
static_assert(std::same_as<decltype(std::declval<BodyTrajectory&>().node(0)), BodyState>);
static_assert(std::same_as<decltype(std::declval<BodyTrajectory&>().at(seconds(0.0))), BodyState>);
static_assert(std::same_as<decltype(std::declval<BodyTrajectory&>().outputs()), std::vector<BodyState>>);
static_assert(
    std::same_as<decltype(std::declval<BodyTrajectory&>().events()), std::vector<Event<Gcrf, Body>>>);
static_assert(std::same_as<decltype(std::declval<const PropagationFailure<Gcrf, Body>&>().trajectory()),
                           const BodyTrajectory&>);

TEST(Trajectory, is_as_accurate_between_the_nodes_as_at_them) {
  const auto trajectory = propagate(body.scenario(), until(60.0));
  ASSERT_GT(trajectory.node_count(), 10U);
  double at_nodes = 0.0;
  double between = 0.0;
  for (std::size_t i = 0; i + 1 < trajectory.node_count(); ++i) {
    const double left = trajectory.node(i).time.value();
    const double right = trajectory.node(i + 1).time.value();
    at_nodes = detail::larger(at_nodes, error(trajectory.node(i + 1), body.exact(right)));
    for (const double part : {0.1, 0.5, 0.77}) {
      const double t = left + part * (right - left);
      between = detail::larger(between, error(trajectory.at(seconds(t)), body.exact(t)));
    }
  }
  EXPECT_LT(at_nodes, accuracy);
  EXPECT_LT(between, 2.0 * at_nodes);
}

TEST(Trajectory, is_an_edge_of_a_frame_graph) {
  const auto trajectory = propagate(body.scenario(), until(60.0));
  const auto graph =
      frame_graph(edge(trajectory), rigid_edge(turned_x(to<Body>, from<Camera>, 0.5 * si::radian)));
  const auto now = graph.at(seconds(33.3));
  const auto state = trajectory.at(seconds(33.3));
  EXPECT_EQ(now.rotation(to<Gcrf>, from<Body>).matrix(), state.R_i_from_b().matrix());
  // Rate of the camera, which is fixed on the body, in the axes of the body.
  EXPECT_EQ(now.angular_velocity(of<Camera>, relative_to<Gcrf>, in<Body>).coordinates(),
            state.w_ib_b.coordinates());
  EXPECT_THROW(graph.at(seconds(60.5)).rotation(to<Gcrf>, from<Body>), BadInput);
  require_motion_laws(trajectory, seconds(33.3), seconds(0.01));
}

TEST(Trajectory, gives_the_states_at_its_nodes_and_at_the_output_times) {
  BodyPropagation how = until(60.0);
  how.output_times = {seconds(0.0), seconds(0.1), seconds(33.3), seconds(60.0)};
  const auto trajectory = propagate(body.scenario(), how);
  const auto outputs = trajectory.outputs();
  ASSERT_EQ(outputs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(outputs[i].time, how.output_times[i]);
    EXPECT_LT(error(outputs[i], body.exact(outputs[i].time.value())), accuracy);
    EXPECT_EQ(error(outputs[i], trajectory.at(outputs[i].time)), 0.0);
  }
  EXPECT_EQ(trajectory.node(0).time, seconds(0.0));
  EXPECT_EQ(error(trajectory.node(trajectory.node_count() - 1), outputs.back()), 0.0);
  EXPECT_FALSE(outputs[0].orbit);
  EXPECT_FALSE(trajectory.stopped());
}

TEST(Trajectory, answers_nothing_outside_its_span) {
  const auto trajectory = propagate(body.scenario(), until(10.0));
  EXPECT_EQ(trajectory.start(), seconds(0.0));
  EXPECT_EQ(trajectory.end(), seconds(10.0));
  for (const double t : {std::nextafter(0.0, -1.0), std::nextafter(10.0, 11.0), std::nan("")}) {
    expect_bad_input(
        [&] { (void)trajectory.at(seconds(t)); },
        "Trajectory of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>() + ": the time ");
    expect_bad_input([&] { (void)trajectory.at(seconds(t)); }, " s is outside [0, 10] s");
  }
  expect_bad_input([&] { (void)trajectory.node(trajectory.node_count()); }, "no node with index");
}

TEST(Trajectory, outlives_what_it_was_made_of) {
  const BodyTrajectory trajectory = [] {
    const BodyTrajectory made = propagate(AxisymmetricBody{}.scenario(), until(10.0));
    return BodyTrajectory(made);
  }();
  EXPECT_LT(error(trajectory.at(seconds(5.0)), body.exact(5.0)), accuracy);
}

/// A turn about z at 0.5 rad/s: sin(angle) rises through zero at 0, 4 pi ... and falls at 2 pi, 6 pi, ...
BodyScenario turntable() {
  return {tensor(3.0, 4.0, 5.0), state_at(0.0, Quaterniond::Identity(), {0.0, 0.0, 0.5})};
}

Root<Gcrf, Body> meridian(const std::string& name, ode::Direction direction = ode::Direction::any,
                          bool stop = false) {
  return {name, [](const BodyState& state) { return state.R_i_from_b().matrix()(1, 0); }, direction, stop};
}

TEST(Roots, are_found_and_reported_with_their_direction) {
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    BodyPropagation how = until(40.0);
    how.attitude = attitude;
    how.roots = {meridian("meridian"), meridian("up", ode::Direction::rising)};
    const auto events = propagate(turntable(), how).events();
    ASSERT_EQ(events.size(), 9U);  // 6 times the meridian: 2 pi, 4 pi, ... 12 pi; 3 of these rising
    std::size_t passages = 0;
    for (const auto& event : events) {
      if (event.name == "meridian") ++passages;
      const double t = event.state.time.value();
      const double half_turn = std::round(t / (2.0 * pi));
      EXPECT_NEAR(t, half_turn * 2.0 * pi, accuracy);
      const bool even = std::remainder(half_turn, 2.0) == 0.0;
      EXPECT_EQ(event.direction, even ? ode::Direction::rising : ode::Direction::falling);
      EXPECT_TRUE(even || event.name == "meridian");
      EXPECT_NEAR(event.state.R_i_from_b().matrix()(1, 0), 0.0, accuracy);
    }
    EXPECT_EQ(passages, 6U);
  }
}

TEST(Roots, one_with_stop_ends_the_trajectory) {
  BodyPropagation how = until(40.0);
  how.output_times = {seconds(1.0), seconds(12.0), seconds(13.0)};
  how.roots = {meridian("any"), meridian("stop", ode::Direction::rising, true)};
  const auto trajectory = propagate(turntable(), how);
  EXPECT_TRUE(trajectory.stopped());
  EXPECT_NEAR(trajectory.end().value(), 4.0 * pi, accuracy);
  ASSERT_FALSE(trajectory.events().empty());
  EXPECT_EQ(trajectory.events().back().name, "stop");
  EXPECT_EQ(trajectory.events().back().state.time, trajectory.end());
  EXPECT_EQ(trajectory.outputs().size(), 2U);  // 13 s was not reached
  expect_bad_input([&] { (void)trajectory.at(seconds(13.0)); }, "is outside [0, 12.56");
}

TEST(Roots, of_time_alone_are_seen_with_a_maximum_step) {
  BodyPropagation how = until(40.0);
  how.roots = {{"window", [](const BodyState& state) { return std::abs(state.time.value() - 17.0) - 0.1; }}};
  how.maximum_step = seconds(0.15);
  const auto events = propagate(turntable(), how).events();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_NEAR(events[0].state.time.value(), 16.9, accuracy);
  EXPECT_EQ(events[0].direction, ode::Direction::falling);
  EXPECT_NEAR(events[1].state.time.value(), 17.1, accuracy);
  EXPECT_EQ(events[1].direction, ode::Direction::rising);
}

/// Returns the failure of a propagation that must fail.
PropagationFailure<Gcrf, Body> failure(const BodyScenario& scenario, const BodyPropagation& how) {
  try {
    propagate(scenario, how);
  } catch (const PropagationFailure<Gcrf, Body>& found) {
    return found;
  }
  throw std::logic_error("the propagation did not fail");
}

/// The texts of an exception and of its nested exceptions, one per line.
std::string chain(const std::exception& error) {
  try {
    std::rethrow_if_nested(error);
  } catch (const std::exception& nested) {
    return std::string{error.what()} + '\n' + chain(nested);
  }
  return error.what();
}

CustomTorque<Gcrf, Body> stuck_valve(double since) {
  return {[since](const BodyState& state) {
    if (state.time.value() > since) throw std::domain_error("the valve is stuck");
    return torque_body(0.0, 0.0, 0.0);
  }};
}

void expect_trajectory_until(const BodyTrajectory& trajectory, double end) {
  ASSERT_GT(trajectory.node_count(), 1U);
  EXPECT_LE(trajectory.end().value(), end);
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const BodyState node = trajectory.node(i);
    EXPECT_LT(error(node, body.exact(node.time.value())), accuracy);
  }
  EXPECT_LT(error(trajectory.at(trajectory.end()), body.exact(trajectory.end().value())), accuracy);
}

TEST(Failure, of_a_torque_that_throws_keeps_the_trajectory_and_the_original) {
  BodyScenario scenario = body.scenario();
  scenario.torques = {stuck_valve(5.0)};
  BodyPropagation how = until(10.0);
  how.output_times = {seconds(1.0), seconds(9.0)};
  const auto found = failure(scenario, how);
  EXPECT_GT(found.time(), 5.0);
  EXPECT_LE(found.time(), 10.0);
  EXPECT_EQ(found.step() + 1, found.trajectory().node_count());
  EXPECT_LT(found.flag(), 0);
  EXPECT_GT(found.trajectory().end().value(), 1.0);
  expect_trajectory_until(found.trajectory(), 5.0);
  EXPECT_EQ(found.trajectory().outputs().size(), 1U);
  expect_said(found, "the right-hand side threw: the valve is stuck");
}

TEST(Failure, holds_what_was_thrown) {
  BodyScenario scenario = body.scenario();
  scenario.torques = {stuck_valve(5.0)};
  try {
    propagate(scenario, until(10.0));
    FAIL() << "nothing was thrown";
  } catch (const ode::Failure& found) {
    EXPECT_TRUE((dynamic_cast<const PropagationFailure<Gcrf, Body>*>(&found) != nullptr));
    const std::string said = chain(found);
    EXPECT_EQ(said.substr(said.rfind('\n') + 1), "the valve is stuck");
  }
}

TEST(Failure, at_the_very_start_leaves_a_trajectory_without_nodes) {
  BodyScenario scenario = body.scenario();
  scenario.torques = {stuck_valve(-1.0)};
  const auto found = failure(scenario, until(10.0));
  EXPECT_EQ(found.time(), 0.0);
  EXPECT_EQ(found.trajectory().node_count(), 0U);
  EXPECT_EQ(found.trajectory().end(), seconds(0.0));
  EXPECT_EQ(found.trajectory().orthonormality_drift(), 0.0);
  expect_bad_input([&] { (void)found.trajectory().at(seconds(0.0)); }, "failed before its first node");
  expect_bad_input([&] { (void)conservation(scenario, found.trajectory()); }, "no node with index 0");
}

TEST(Failure, of_a_torque_that_is_not_finite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    BodyScenario scenario = body.scenario();
    scenario.torques = {{[bad](const BodyState& state) {
      return (state.time.value() > 5.0 ? bad : 0.0) * torque_body(1.0, 1.0, 1.0);
    }}};
    const auto found = failure(scenario, until(10.0));
    EXPECT_GT(found.time(), 5.0);
    expect_trajectory_until(found.trajectory(), 5.0);
    expect_said(found, "propagate: failed at t = ");
    expect_said(found, "w_ib_b.x of the right-hand side is ");
  }
}

TEST(Failure, of_a_root_that_throws_or_is_not_finite) {
  BodyPropagation how = until(10.0);
  how.roots = {
      {"eclipse", [](const BodyState& state) { return state.time.value() > 5.0 ? std::nan("") : 1.0; }}};
  const auto not_finite = failure(body.scenario(), how);
  expect_said(not_finite, "(eclipse) is nan");

  how.roots = {{"eclipse", [](const BodyState& state) -> double {
                  if (state.time.value() > 5.0) throw std::domain_error("no Sun");
                  return 1.0;
                }}};
  const auto threw = failure(body.scenario(), how);
  expect_said(threw, "(eclipse) threw: no Sun");
  EXPECT_GT(threw.time(), 5.0);
}

TEST(Failure, after_max_steps) {
  BodyPropagation how = until(60.0);
  how.max_steps = 10;
  const auto found = failure(body.scenario(), how);
  EXPECT_EQ(found.step(), 10U);
  EXPECT_LT(found.flag(), 0);
  EXPECT_EQ(found.trajectory().node_count(), 11U);
  EXPECT_EQ(found.trajectory().end().value(), found.time());
  expect_trajectory_until(found.trajectory(), 60.0);
  expect_said(found, "max_steps = 10 reached");
}

BodyScenario in_orbit() {
  BodyScenario scenario = body.scenario();
  scenario.mu = Quantity<si::gravitational_parameter>::from_value(3.986004418e14);
  scenario.initial.orbit = body_orbit({7e6, 0.0, 0.0}, {0.0, 5000.0, 6000.0});
  return scenario;
}

TEST(ConservationReport, of_a_torque_free_body_in_orbit_is_small) {
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    BodyPropagation how = until(600.0);
    how.attitude = attitude;
    const Conservation report = conservation(in_orbit(), propagate(in_orbit(), how));
    constexpr double drift = 1e-9;  // of some thousand steps at 1e-12
    EXPECT_LT(report.orthonormality, drift);
    EXPECT_LT(report.rotational_energy.value(), drift);
    EXPECT_LT(report.angular_momentum.value(), drift);
    EXPECT_LT(report.orbital_energy.value(), drift);
    EXPECT_LT(report.orbital_angular_momentum.value(), drift);
  }
}

TEST(ConservationReport, says_what_a_loose_tolerance_costs) {
  const auto report = [](double tolerance) {
    BodyPropagation how = until(100.0);
    how.tolerances = {tolerance, tolerance, tolerance * (si::radian / si::second),
                      tolerance * 1e7 * si::metre, tolerance * 1e4 * (si::metre / si::second)};
    return conservation(in_orbit(), propagate(in_orbit(), how));
  };
  const Conservation tight = report(1e-12);
  const Conservation loose = report(1e-5);
  EXPECT_GT(loose.orthonormality, 1e3 * tight.orthonormality);
  EXPECT_GT(loose.rotational_energy.value(), 1e3 * tight.rotational_energy.value());
  EXPECT_GT(loose.angular_momentum.value(), 1e3 * tight.angular_momentum.value());
  EXPECT_LT(loose.angular_momentum.value(), 0.1);  // but smaller than the momentum
}

/// The report gives the relative change between the nodes. Here it uses the inertia of another body.
TEST(ConservationReport, finds_a_change) {
  const BodyScenario flown = body.scenario();
  BodyScenario claimed = flown;
  claimed.inertia = tensor(2.0, 2.6, 3.0);  // T and h of this body are not constant in the motion
  const auto trajectory = propagate(flown, until(60.0));
  const double w = std::hypot(0.3, 0.2);  // turns in the xy plane: 2T varies by 0.6 wy^2
  const double start = 2.0 * 0.09 + 2.6 * 0.04 + 3.0 * 0.25;
  const double largest = 0.6 * std::max(w * w - 0.04, 0.04);
  EXPECT_NEAR(conservation(claimed, trajectory).rotational_energy.value(), largest / start,
              0.01 * largest / start);
  EXPECT_GT(conservation(claimed, trajectory).angular_momentum.value(), 0.01);
}

// With another mu than the flown one v^2/2 - mu/r changes as 1/r does.
TEST(ConservationReport, finds_a_change_of_the_orbital_energy) {
  BodyScenario claimed = in_orbit();
  const auto trajectory = propagate(in_orbit(), until(3000.0));
  const double mu = claimed.mu->value();
  claimed.mu = 2.0 * *claimed.mu;
  const auto radius = [&](std::size_t i) { return norm(trajectory.node(i).orbit->position).value(); };
  const double v = norm(trajectory.node(0).orbit->velocity).value();
  double largest = 0.0;
  for (std::size_t i = 1; i < trajectory.node_count(); ++i)
    largest = std::max(largest, mu * std::abs(1.0 / radius(i) - 1.0 / radius(0)));
  const double expected = largest / std::abs(v * v / 2.0 - 2.0 * mu / radius(0));
  EXPECT_GT(expected, 0.05);
  EXPECT_NEAR(conservation(claimed, trajectory).orbital_energy.value(), expected, accuracy);
}

TEST(ConservationReport, says_what_a_loose_tolerance_costs_an_orbit) {
  const auto report = [](double tolerance) {
    BodyScenario slow = in_orbit();
    slow.initial.w_ib_b = rate_body(1e-3 * body.w0);
    BodyPropagation how = until(20000.0);
    how.tolerances = {tolerance, tolerance, tolerance * (si::radian / si::second),
                      tolerance * 1e7 * si::metre, tolerance * 1e4 * (si::metre / si::second)};
    return conservation(slow, propagate(slow, how));
  };
  const Conservation tight = report(1e-12), loose = report(1e-3);
  EXPECT_GT(loose.orbital_energy.value(), 1e6 * tight.orbital_energy.value());
  EXPECT_GT(loose.orbital_angular_momentum.value(), 1e6 * tight.orbital_angular_momentum.value());
}

TEST(ConservationReport, leaves_out_what_is_not_conserved_or_not_there) {
  BodyScenario pushed = body.scenario();
  pushed.pulses = {{seconds(1.0), seconds(2.0), torque_body(0.1, 0.0, 0.0)}};
  const Conservation of_pushed = conservation(pushed, propagate(pushed, until(10.0)));
  EXPECT_FALSE(of_pushed.rotational_energy);
  EXPECT_FALSE(of_pushed.angular_momentum);
  EXPECT_FALSE(of_pushed.orbital_energy);
  EXPECT_FALSE(of_pushed.orbital_angular_momentum);
  EXPECT_LT(of_pushed.orthonormality, accuracy);

  BodyScenario gradient = in_orbit();
  gradient.gravity_gradient = true;
  const Conservation of_gradient = conservation(gradient, propagate(gradient, until(10.0)));
  EXPECT_FALSE(of_gradient.rotational_energy);
  EXPECT_LT(of_gradient.orbital_energy.value(), accuracy);
  EXPECT_LT(of_gradient.orbital_angular_momentum.value(), accuracy);
}

TEST(ConservationReport, needs_the_mu_of_an_orbit) {
  const auto trajectory = propagate(in_orbit(), until(10.0));
  expect_bad_input([&] { (void)conservation(body.scenario(), trajectory); },
                   "the trajectory has an orbit, but mu is not given");
}

}  // namespace
}  // namespace vectrix::test::trajectory_test
