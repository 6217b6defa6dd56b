#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>
#include <vectrix/dynamics/craft/conservation.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/motion_laws.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>

#include "craft/rigid_craft.hpp"

// The results of propagate(): the trajectory of a craft, its events, or a failure.
namespace vectrix::test::craft_trajectory_test {
namespace {

using namespace rigid_craft;
using Flown = CraftTrajectory<Turning>;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;
constexpr double accuracy = 1e-9;  // of a run of some tens of radians at 1e-12

struct Camera : moving_frame {};

const AxisymmetricBody body;
const Turning craft = turning(body);

Flown run(const CraftPropagation& how) {
  return propagate(scenario(craft), start_of(craft, body.exact(0.0)), how);
}
double error(const CraftState<Turning>& found, const BodyState& exact) {
  return test::error(body_state(found), exact);
}
double error(const CraftState<Turning>& found, const CraftState<Turning>& expected) {
  return test::error(body_state(found), body_state(expected));
}

// A trajectory cannot be changed: it returns copies.
static_assert(!std::is_default_constructible_v<Flown>);
static_assert(std::is_copy_constructible_v<Flown>);
static_assert(std::same_as<decltype(std::declval<Flown&>().solution().statistics()), ode::Statistics>);
static_assert(std::same_as<decltype(std::declval<Flown&>().node(0)), CraftState<Turning>>);
static_assert(std::same_as<decltype(std::declval<Flown&>().at(seconds(0.0))), CraftState<Turning>>);
static_assert(std::same_as<decltype(std::declval<Flown&>().outputs()), std::vector<CraftState<Turning>>>);
static_assert(std::same_as<decltype(std::declval<Flown&>().events()), std::vector<CraftEvent<Turning>>>);
static_assert(
    std::same_as<decltype(std::declval<const CraftFailure<Turning>&>().trajectory()), const Flown&>);

TEST(CraftTrajectory, is_as_accurate_between_the_nodes_as_at_them) {
  const auto trajectory = run(until(60.0));
  ASSERT_GT(trajectory.node_count(), 10U);
  double at_nodes = 0.0;
  double between = 0.0;
  for (std::size_t i = 0; i + 1 < trajectory.node_count(); ++i) {
    const double left = trajectory.node(i).time().value();
    const double right = trajectory.node(i + 1).time().value();
    at_nodes = detail::larger(at_nodes, error(trajectory.node(i + 1), body.exact(right)));
    for (const double part : {0.1, 0.5, 0.77}) {
      const double t = left + part * (right - left);
      between = detail::larger(between, error(trajectory.at(seconds(t)), body.exact(t)));
    }
  }
  EXPECT_LT(at_nodes, accuracy);
  EXPECT_LT(between, 2.0 * at_nodes);
}

TEST(CraftTrajectory, is_an_edge_of_a_frame_graph) {
  const auto trajectory = run(until(60.0));
  const auto graph =
      frame_graph(edge(trajectory), rigid_edge(turned_x(to<Body>, from<Camera>, 0.5 * si::radian)));
  const auto now = graph.at(seconds(33.3));
  const auto state = trajectory.at(seconds(33.3));
  EXPECT_EQ(now.rotation(to<Gcrf>, from<Body>).matrix(), state.turning().rotation.matrix());
  // Rate of the camera, which is fixed on the body, in the axes of the body.
  EXPECT_EQ(now.angular_velocity(of<Camera>, relative_to<Gcrf>, in<Body>).coordinates(),
            state.turning().angular_velocity.coordinates());
  EXPECT_THROW(graph.at(seconds(60.5)).rotation(to<Gcrf>, from<Body>), BadInput);
  require_motion_laws(trajectory, seconds(33.3), seconds(0.01));
}

TEST(CraftTrajectory, gives_the_states_at_its_nodes_and_at_the_output_times) {
  CraftPropagation how = until(60.0);
  how.output_times = {seconds(0.0), seconds(0.1), seconds(33.3), seconds(60.0)};
  const auto trajectory = run(how);
  const auto outputs = trajectory.outputs();
  ASSERT_EQ(outputs.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(outputs[i].time(), how.output_times[i]);
    EXPECT_LT(error(outputs[i], body.exact(outputs[i].time().value())), accuracy);
    EXPECT_EQ(error(outputs[i], trajectory.at(outputs[i].time())), 0.0);
  }
  EXPECT_EQ(trajectory.node(0).time(), seconds(0.0));
  EXPECT_EQ(error(trajectory.node(trajectory.node_count() - 1), outputs.back()), 0.0);
  EXPECT_FALSE(trajectory.stopped());
}

TEST(CraftTrajectory, answers_nothing_outside_its_span) {
  const auto trajectory = run(until(10.0));
  EXPECT_EQ(trajectory.start(), seconds(0.0));
  EXPECT_EQ(trajectory.end(), seconds(10.0));
  for (const double t : {std::nextafter(0.0, -1.0), std::nextafter(10.0, 11.0), std::nan("")}) {
    expect_bad_input(
        [&] { (void)trajectory.at(seconds(t)); },
        "CraftTrajectory of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>() + ": the time ");
    expect_bad_input([&] { (void)trajectory.at(seconds(t)); }, " s is outside [0, 10] s");
    expect_bad_input([&] { (void)trajectory(seconds(t)); }, " s is outside [0, 10] s");
  }
  expect_bad_input([&] { (void)trajectory.node(trajectory.node_count()); }, "no node with index");
}

TEST(CraftTrajectory, outlives_what_it_was_made_of) {
  const Flown trajectory = [] {
    const Turning gone = turning(body);
    const Flown made = propagate(scenario(gone), start_of(gone, body.exact(0.0)), until(10.0));
    return Flown(made);
  }();
  EXPECT_LT(error(trajectory.at(seconds(5.0)), body.exact(5.0)), accuracy);
}

/// A turn about z at 0.5 rad/s: sin(angle) rises through zero at 0, 4 pi ... and falls at 2 pi, 6 pi, ...
const Turning table(tensor(3.0, 4.0, 5.0));
CraftState<Turning> turntable() {
  return start_of(table, state_at(0.0, Quaterniond::Identity(), {0.0, 0.0, 0.5}));
}
const auto height = [](const Now<Turning>& now) { return now.rotation(to<Gcrf>, from<Body>).matrix()(1, 0); };

TEST(CraftRoots, are_found_and_reported_with_their_direction) {
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    CraftPropagation how = until(40.0);
    how.attitude = attitude;
    const auto watched = scenario(table, when("meridian", height, ode::Direction::any),
                                  when("up", height, ode::Direction::rising));
    const auto events = propagate(watched, turntable(), how).events();
    ASSERT_EQ(events.size(), 9U);  // 6 times the meridian: 2 pi, 4 pi, ... 12 pi; 3 of these rising
    std::size_t passages = 0;
    for (const auto& event : events) {
      if (event.name == "meridian") ++passages;
      const double t = event.state.time().value();
      const double half_turn = std::round(t / (2.0 * pi));
      EXPECT_NEAR(t, half_turn * 2.0 * pi, accuracy);
      const bool even = std::remainder(half_turn, 2.0) == 0.0;
      EXPECT_EQ(event.direction, even ? ode::Direction::rising : ode::Direction::falling);
      EXPECT_TRUE(even || event.name == "meridian");
      EXPECT_NEAR(event.state.turning().rotation.matrix()(1, 0), 0.0, accuracy);
    }
    EXPECT_EQ(passages, 6U);
  }
}

TEST(CraftRoots, one_with_stop_ends_the_trajectory) {
  CraftPropagation how = until(40.0);
  how.output_times = {seconds(1.0), seconds(12.0), seconds(13.0)};
  const auto watched = scenario(table, when("any", height, ode::Direction::any),
                                when("stop", height, ode::Direction::rising, stop));
  const auto trajectory = propagate(watched, turntable(), how);
  EXPECT_TRUE(trajectory.stopped());
  EXPECT_NEAR(trajectory.end().value(), 4.0 * pi, accuracy);
  ASSERT_FALSE(trajectory.events().empty());
  EXPECT_EQ(trajectory.events().back().name, "stop");
  EXPECT_EQ(trajectory.events().back().state.time(), trajectory.end());
  EXPECT_EQ(trajectory.outputs().size(), 2U);  // 13 s was not reached
  expect_bad_input([&] { (void)trajectory.at(seconds(13.0)); }, "is outside [0, 12.56");
}

TEST(CraftRoots, of_time_alone_are_seen_with_a_maximum_step) {
  CraftPropagation how = until(40.0);
  const auto watched = scenario(
      table, when(
                 "window", [](const Now<Turning>& now) { return std::abs(now.time().value() - 17.0) - 0.1; },
                 ode::Direction::any));
  how.maximum_step = seconds(0.15);
  const auto events = propagate(watched, turntable(), how).events();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_NEAR(events[0].state.time().value(), 16.9, accuracy);
  EXPECT_EQ(events[0].direction, ode::Direction::falling);
  EXPECT_NEAR(events[1].state.time().value(), 17.1, accuracy);
  EXPECT_EQ(events[1].direction, ode::Direction::rising);
}

/// Returns the failure of a propagation that must fail.
template <class... Parts> CraftFailure<Turning> failure(const CraftPropagation& how, const Parts&... parts) {
  try {
    propagate(scenario(craft, parts...), start_of(craft, body.exact(0.0)), how);
  } catch (const CraftFailure<Turning>& found) {
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

auto stuck_valve(double since) {
  return [since](const Now<Turning>& now, Forces<Turning>&) {
    if (now.time().value() > since) throw std::domain_error("the valve is stuck");
  };
}

void expect_trajectory_until(const Flown& trajectory, double end) {
  ASSERT_GT(trajectory.node_count(), 1U);
  EXPECT_LE(trajectory.end().value(), end);
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const CraftState<Turning> node = trajectory.node(i);
    EXPECT_LT(error(node, body.exact(node.time().value())), accuracy);
  }
  EXPECT_LT(error(trajectory.at(trajectory.end()), body.exact(trajectory.end().value())), accuracy);
}

TEST(CraftRunFailure, of_a_torque_that_throws_keeps_the_trajectory_and_the_original) {
  CraftPropagation how = until(10.0);
  how.output_times = {seconds(1.0), seconds(9.0)};
  const auto found = failure(how, stuck_valve(5.0));
  EXPECT_GT(found.time(), 5.0);
  EXPECT_LE(found.time(), 10.0);
  EXPECT_EQ(found.step() + 1, found.trajectory().node_count());
  EXPECT_LT(found.flag(), 0);
  EXPECT_GT(found.trajectory().end().value(), 1.0);
  expect_trajectory_until(found.trajectory(), 5.0);
  EXPECT_EQ(found.trajectory().outputs().size(), 1U);
  expect_said(found, "the right-hand side threw: the valve is stuck");
}

TEST(CraftRunFailure, holds_what_was_thrown) {
  try {
    propagate(scenario(craft, stuck_valve(5.0)), start_of(craft, body.exact(0.0)), until(10.0));
    FAIL() << "nothing was thrown";
  } catch (const ode::Failure& found) {
    EXPECT_TRUE((dynamic_cast<const CraftFailure<Turning>*>(&found) != nullptr));
    const std::string said = chain(found);
    EXPECT_EQ(said.substr(said.rfind('\n') + 1), "the valve is stuck");
  }
}

TEST(CraftRunFailure, at_the_very_start_leaves_a_trajectory_without_nodes) {
  const auto found = failure(until(10.0), stuck_valve(-1.0));
  EXPECT_EQ(found.time(), 0.0);
  EXPECT_EQ(found.trajectory().node_count(), 0U);
  EXPECT_EQ(found.trajectory().end(), seconds(0.0));
  EXPECT_EQ(found.trajectory().orthonormality_drift(), 0.0);
  expect_bad_input([&] { (void)found.trajectory().at(seconds(0.0)); }, "failed before its first node");
  expect_bad_input([&] { (void)conservation(scenario(craft), found.trajectory()); }, "no node with index 0");
}

TEST(CraftRunFailure, of_a_torque_that_is_not_finite) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::nan("")}) {
    const auto found = failure(until(10.0), [bad](const Now<Turning>& now, Forces<Turning>& forces) {
      forces.torque(of<Body>, (now.time().value() > 5.0 ? bad : 0.0) * torque_body(1.0, 1.0, 1.0));
    });
    EXPECT_GT(found.time(), 5.0);
    expect_trajectory_until(found.trajectory(), 5.0);
    expect_said(found, "propagate " + frame_name<Body>() + ": failed at t = ");
    expect_said(found, "wx of the right-hand side is ");
  }
}

TEST(CraftRunFailure, of_a_root_that_throws_or_is_not_finite) {
  const auto late = [](const Now<Turning>& now) { return now.time().value() > 5.0 ? std::nan("") : 1.0; };
  const auto not_finite = failure(until(10.0), when("eclipse", late, ode::Direction::any));
  expect_said(not_finite, "(eclipse) is nan");

  const auto throws = [](const Now<Turning>& now) -> double {
    if (now.time().value() > 5.0) throw std::domain_error("no Sun");
    return 1.0;
  };
  const auto threw = failure(until(10.0), when("eclipse", throws, ode::Direction::any));
  expect_said(threw, "(eclipse) threw: no Sun");
  EXPECT_GT(threw.time(), 5.0);
}

TEST(CraftRunFailure, after_max_steps) {
  CraftPropagation how = until(60.0);
  how.max_steps = 10;
  const auto found = failure(how);
  EXPECT_EQ(found.step(), 10U);
  EXPECT_LT(found.flag(), 0);
  EXPECT_EQ(found.trajectory().node_count(), 11U);
  EXPECT_EQ(found.trajectory().end().value(), found.time());
  expect_trajectory_until(found.trajectory(), 60.0);
  expect_said(found, "max_steps = 10 reached");
}

// Without dense output the run answers at its nodes and output times only.
TEST(CraftTrajectory, without_dense_output_has_its_nodes_and_outputs) {
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    CraftPropagation how = until(60.0);
    how.attitude = attitude;
    how.dense_output = false;
    how.output_times = {seconds(33.3)};
    const auto trajectory = run(how);
    ASSERT_EQ(trajectory.outputs().size(), 1U);
    EXPECT_LT(error(trajectory.outputs()[0], body.exact(33.3)), accuracy);
    const double first = trajectory.node(0).time().value(), second = trajectory.node(1).time().value();
    EXPECT_LT(error(trajectory.at(seconds(second)), body.exact(second)), accuracy);
    EXPECT_THROW(trajectory.at(seconds((first + second) / 2.0)), BadInput);
  }
}

TEST(CraftTrajectory, of_a_free_hub_is_an_edge_with_a_place) {
  const Free satellite = free(body);
  const auto trajectory =
      propagate(scenario(satellite), start_of(satellite, body.exact(0.0), {7.0, 0.0, 2.0}, {0.0, 5.0, 6.0}),
                until(60.0));
  const auto graph = frame_graph(edge(trajectory));
  const auto now = graph.at(seconds(33.3));
  EXPECT_LT((now.position(of<Body>, relative_to<Gcrf>, in<Gcrf>).coordinates() -
             Vector3d(7.0, 33.3 * 5.0, 2.0 + 33.3 * 6.0))
                .norm(),
            accuracy);
  require_motion_laws(trajectory, seconds(33.3), seconds(0.01));
}

}  // namespace
}  // namespace vectrix::test::craft_trajectory_test
