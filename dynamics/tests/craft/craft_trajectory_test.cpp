#include <array>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>
#include <vectrix/dynamics/craft/conservation.hpp>
#include <vectrix/dynamics/craft/graph.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/motion_laws.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>

#include "craft/rigid_craft.hpp"

// The results of propagate(): the trajectory of a craft, its events, its conservation report, or a failure.
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

constexpr double mu_of_earth = 3.986004418e14;
const Free satellite = free(body);

/// The attraction of a point mass without its gradient.
auto field_of(double mu) {
  return [mu = Quantity<si::gravitational_parameter>::from_value(mu)](const Now<Free>& now,
                                                                      Forces<Free>& forces) {
    forces.field(point_mass_gravity(mu, now.position(of<Body>, relative_to<Gcrf>, in<Gcrf>).vector()));
  };
}
CraftTrajectory<Free> in_orbit(const Eigen::Vector3d& w, const CraftPropagation& how) {
  return propagate(scenario(satellite, field_of(mu_of_earth)),
                   start_of(satellite, state_at(0.0, body.q0, w), {7e6, 0.0, 0.0}, {0.0, 5000.0, 6000.0}),
                   how);
}

/// How far what a torque-free body in an orbit keeps has changed.
struct Kept {
  double orthonormality, energy, angular_momentum, orbital_energy, orbital_angular_momentum;
};
Vector3d place(const Now<Free>& now) {
  return now.position(of<Body>, relative_to<Gcrf>, in<Gcrf>).coordinates();
}
Vector3d speed(const Now<Free>& now) {
  return now.velocity(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>).coordinates();
}
double orbital_energy_change(const CraftTrajectory<Free>& flight, double mu) {
  return largest_change(satellite, flight, [mu](const Now<Free>& now) {
    return speed(now).squaredNorm() / 2.0 - mu / place(now).norm();
  });
}
Kept kept(const CraftTrajectory<Free>& flight) {
  const Inertia<Body> J_b = tensor(body.a, body.a, body.c);
  const auto rate = [](const Now<Free>& now) {
    return now.angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);
  };
  const auto change = [&](const auto& quantity) { return largest_change(satellite, flight, quantity); };
  return {
      flight.orthonormality_drift(),
      change([&](const Now<Free>& now) { return kinetic_energy(J_b, rate(now)); }),
      change([&](const Now<Free>& now) { return now.rotation(to<Gcrf>, from<Body>) * (J_b * rate(now)); }),
      orbital_energy_change(flight, mu_of_earth),
      change([&](const Now<Free>& now) { return Vector3d(place(now).cross(speed(now))); }),
  };
}

TEST(CraftConservationReport, of_a_torque_free_body_is_small) {
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    constexpr double drift = 1e-9;  // of some thousand steps at 1e-12
    CraftPropagation how = until(600.0);
    how.attitude = attitude;
    const CraftConservation report = conservation(scenario(craft), run(how));
    EXPECT_LT(report.orthonormality, drift);
    EXPECT_LT(report.energy.value(), drift);
    EXPECT_LT(report.angular_momentum.value(), drift);
    EXPECT_FALSE(report.momentum);  // the hub is only turning

    const Kept in_space = kept(in_orbit(body.w0, how));
    EXPECT_LT(in_space.orthonormality, drift);
    EXPECT_LT(in_space.energy, drift);
    EXPECT_LT(in_space.angular_momentum, drift);
    EXPECT_LT(in_space.orbital_energy, drift);
    EXPECT_LT(in_space.orbital_angular_momentum, drift);

    const auto drifting = propagate(
        scenario(satellite), start_of(satellite, body.exact(0.0), {7e6, 0.0, 0.0}, {0.0, 5.0, 6.0}), how);
    EXPECT_LT(conservation(scenario(satellite), drifting).momentum.value(), drift);
  }
}

CraftPropagation with_tolerance(double end, double tolerance) {
  CraftPropagation how = until(end);
  how.relative_tolerance = tolerance;
  how.absolute_tolerances = {tolerance * si::radian, tolerance * (si::radian / si::second),
                             tolerance * 1e7 * si::metre, tolerance * 1e4 * (si::metre / si::second),
                             tolerance};
  return how;
}

TEST(CraftConservationReport, says_what_a_loose_tolerance_costs) {
  const auto report = [](double tolerance) {
    return conservation(scenario(craft), run(with_tolerance(100.0, tolerance)));
  };
  const CraftConservation tight = report(1e-12), loose = report(1e-5);
  EXPECT_GT(loose.orthonormality, 1e3 * tight.orthonormality);
  EXPECT_GT(loose.energy.value(), 1e3 * tight.energy.value());
  EXPECT_GT(loose.angular_momentum.value(), 1e3 * tight.angular_momentum.value());
  EXPECT_LT(loose.angular_momentum.value(), 0.1);  // but smaller than the momentum
}

/// The report gives the relative change between the nodes. Here it uses the inertia of another body.
TEST(CraftConservationReport, finds_a_change) {
  const Turning claimed(tensor(2.0, 2.6, 3.0));  // T and h of this body are not constant in the motion
  const auto trajectory = run(until(60.0));
  const double w = std::hypot(0.3, 0.2);  // turns in the xy plane: 2T varies by 0.6 wy^2
  const double start = 2.0 * 0.09 + 2.6 * 0.04 + 3.0 * 0.25;
  const double largest = 0.6 * std::max(w * w - 0.04, 0.04);
  const CraftConservation report = conservation(scenario(claimed), trajectory);
  EXPECT_NEAR(report.energy.value(), largest / start, 0.01 * largest / start);
  EXPECT_GT(report.angular_momentum.value(), 0.01);
}

// With another mu than the flown one v^2/2 - mu/r changes as 1/r does.
TEST(LargestChange, finds_a_change_of_the_orbital_energy) {
  const auto trajectory = in_orbit(body.w0, until(3000.0));
  const auto radius = [&](std::size_t i) {
    return trajectory.node(i).hub_motion().translation.coordinates().norm();
  };
  const double v = trajectory.node(0).hub_motion().velocity.coordinates().norm();
  double largest = 0.0;
  for (std::size_t i = 1; i < trajectory.node_count(); ++i)
    largest = std::max(largest, mu_of_earth * std::abs(1.0 / radius(i) - 1.0 / radius(0)));
  const double expected = largest / std::abs(v * v / 2.0 - 2.0 * mu_of_earth / radius(0));
  EXPECT_GT(expected, 0.05);
  EXPECT_NEAR(orbital_energy_change(trajectory, 2.0 * mu_of_earth), expected, accuracy);
}

TEST(LargestChange, says_what_a_loose_tolerance_costs_an_orbit) {
  const auto report = [](double tolerance) {
    return kept(in_orbit(1e-3 * body.w0, with_tolerance(20000.0, tolerance)));
  };
  const Kept tight = report(1e-12), loose = report(1e-3);
  EXPECT_GT(loose.orbital_energy, 1e6 * tight.orbital_energy);
  EXPECT_GT(loose.orbital_angular_momentum, 1e6 * tight.orbital_angular_momentum);
}

TEST(LargestChange, of_what_was_zero_is_the_change) {
  const auto elapsed = [](const Now<Turning>& now) { return now.time(); };
  EXPECT_EQ(largest_change(craft, run(until(10.0)), elapsed), 10.0);
}

TEST(CraftConservationReport, leaves_out_what_is_not_conserved_or_not_there) {
  const auto pushed =
      scenario(craft, pulse(craft, of<Body>, torque_body(0.1, 0.0, 0.0), seconds(1.0), seconds(2.0)));
  const CraftConservation of_pushed =
      conservation(pushed, propagate(pushed, start_of(craft, body.exact(0.0)), until(10.0)));
  EXPECT_FALSE(of_pushed.energy);
  EXPECT_FALSE(of_pushed.momentum);
  EXPECT_FALSE(of_pushed.angular_momentum);
  EXPECT_LT(of_pushed.orthonormality, accuracy);

  const auto attracted = scenario(
      satellite, point_mass(satellite, Quantity<si::gravitational_parameter>::from_value(mu_of_earth)));
  const auto flight = propagate(
      attracted, start_of(satellite, body.exact(0.0), {7e6, 0.0, 0.0}, {0.0, 5000.0, 6000.0}), until(10.0));
  EXPECT_FALSE(conservation(attracted, flight).energy);
  EXPECT_LT(kept(flight).orbital_energy, accuracy);
  EXPECT_LT(kept(flight).orbital_angular_momentum, accuracy);
}

}  // namespace
}  // namespace vectrix::test::craft_trajectory_test
