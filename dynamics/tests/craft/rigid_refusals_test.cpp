#include <functional>
#include <limits>
#include <vector>
#include <vectrix/dynamics/force/gravity.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "craft/rigid_craft.hpp"

// What acts on a craft of one rigid body, and what its run refuses.
namespace vectrix::test::rigid_refusals_test {
namespace {

using namespace rigid_craft;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

const AxisymmetricBody body;

Quantity<si::gravitational_parameter> mu(double value = 3.986004418e14) {
  return Quantity<si::gravitational_parameter>::from_value(value);
}
auto constant(double x) {
  return [x](const auto&, auto& forces) { forces.torque(of<Body>, torque_body(x, 0.0, 0.0)); };
}

// The angular acceleration of a body of unit inertia is the torque on it.
TEST(RigidTorque, a_pulse_acts_from_its_start_to_before_its_stop) {
  const Turning craft(tensor(1.0, 1.0, 1.0));
  const auto pulsed =
      scenario(craft, pulse(craft, of<Body>, torque_body(1.0, 2.0, 3.0), seconds(1.0), seconds(2.0)),
               pulse(craft, of<Body>, torque_body(10.0, 0.0, 0.0), seconds(1.5), seconds(3.0)));
  const auto flight = propagate(
      pulsed, start_of(craft, state_at(0.0, Quaterniond::Identity(), Vector3d::Zero())), until(4.0));
  const auto torque_at = [&](double t) {
    return motion_at(pulsed, flight, seconds(t)).angular_acceleration(of<Body>, in<Body>).coordinates();
  };
  constexpr double rounding = 1e-14;  // of w x w, with |w| up to 20 rad/s
  EXPECT_EQ(torque_at(std::nextafter(1.0, 0.0)), Vector3d::Zero());
  EXPECT_LE((torque_at(1.0) - Vector3d(1.0, 2.0, 3.0)).norm(), rounding);
  EXPECT_LE((torque_at(std::nextafter(1.5, 0.0)) - Vector3d(1.0, 2.0, 3.0)).norm(), rounding);
  EXPECT_LE((torque_at(1.5) - Vector3d(11.0, 2.0, 3.0)).norm(), rounding);
  EXPECT_LE((torque_at(2.0) - Vector3d(10.0, 0.0, 0.0)).norm(), rounding);
  EXPECT_LE(torque_at(3.0).norm(), rounding);
}

TEST(RigidTorque, is_the_sum_of_all) {
  const Inertia<Body> J_b = tensor(2.0, 2.0, 3.0);
  const Free craft(J_b);
  const BodyState resting = state_at(0.0, body.q0, Vector3d::Zero());
  const auto start = start_of(craft, resting, {7e6, 0.0, 0.0}, {0.0, 7500.0, 0.0});
  const auto all = scenario(craft, point_mass(craft, mu()), constant(1.0), constant(20.0),
                            pulse(craft, of<Body>, torque_body(300.0, 0.0, 0.0), seconds(0.0), seconds(2.0)));
  const auto flight = propagate(all, start, until(1e-3));
  const Vector3d alpha =
      motion_at(all, flight, seconds(0.0)).angular_acceleration(of<Body>, in<Body>).coordinates();
  const Vector<Body, si::length> r_b =
      inverse(resting.R_i_from_b()) * vector<si::length>(in<Gcrf>, Vector3d(7e6, 0.0, 0.0));
  const Vector3d gradient = gravity_gradient_torque(mu(), J_b, r_b).coordinates();
  EXPECT_GT(gradient.norm(), 0.0);
  EXPECT_LT((J_b.matrix() * alpha - gradient - Vector3d(321.0, 0.0, 0.0)).norm(), 1e-12);
}

TEST(RigidMomentum, is_turned_into_the_inertial_frame) {
  const Turning craft = turning(body);  // its angular momentum is fixed in space
  const auto momentum_at = [&](double t) {
    return motion(craft, start_of(craft, body.exact(t))).angular_momentum().coordinates();
  };
  EXPECT_LT((momentum_at(7.0) - momentum_at(0.0)).norm(), 1e-14 * 10.0);
  EXPECT_NEAR(momentum_at(0.0).norm(), Vector3d(0.6, -0.4, 1.5).norm(), 1e-14);
}

// g++ 12 failed on lists that the braces leave out with an internal error.
TEST(CraftPropagation, may_be_written_in_the_braces_of_a_list) {
  const std::vector<CraftPropagation> runs = {{.end = seconds(1.0),
                                               .relative_tolerance = 1e-12,
                                               .absolute_tolerances = until(1.0).absolute_tolerances}};
  EXPECT_TRUE(runs[0].output_times.empty());
  EXPECT_TRUE(runs[0].dense_output);
  EXPECT_EQ(runs[0].attitude, AttitudeState::quaternion);
}

TEST(RefusedRigidCraft, what_is_not_a_number_or_has_no_inverse) {
  const Turning craft = turning(body);
  const Free satellite = free(body);
  expect_bad_input([&] { start_of(craft, state_at(nan, body.q0, body.w0)); }, "the time is nan s");
  for (const double value : {0.0, -1.0, infinity, nan}) {
    expect_bad_input([&] { point_mass(satellite, mu(value)); },
                     "point_mass: the gravitational parameter is " + detail::text(value) + " m^3/s^2");
  }
  const auto unit = si::kilogram_square_metre;
  const auto rod = inertia_from_principal_moments(in<Body>, 0.0 * unit, 4.0 * unit, 4.0 * unit);
  const std::string no_inverse =
      "Euler's equation needs the inverse of the inertia [0 0 0; 0 4 0; 0 0 4] kg m^2";
  expect_bad_input([&] { Turning{rod}; }, no_inverse);
  expect_bad_input([&] { Free{rod}; }, no_inverse);
  expect_bad_input([&] { Free{rod}; }, frame_name<Body>());
  expect_bad_input([&] { at_times({seconds(1.0), seconds(infinity)}, becomes(1)); }, "a time is inf s");
}

TEST(RefusedRigidCraft, a_pulse_that_does_not_last) {
  const Turning craft = turning(body);
  const auto refused = [&](double start, double stop, const std::string& text) {
    expect_bad_input(
        [&] { pulse(craft, of<Body>, torque_body(1.0, 0.0, 0.0), seconds(start), seconds(stop)); }, text);
  };
  refused(2.0, 1.0, "pulse: it starts at 2 s and ends at 1 s");
  refused(2.0, 2.0, "pulse: it starts at 2 s and ends at 2 s");
  refused(nan, 1.0, "pulse: the start is nan s");
  refused(0.0, infinity, "pulse: the end is inf s");
}

/// Expects that a run of one second from 0 refuses its settings after `change`, with `text` in the message.
template <class Change> void expect_refused_run(const Change& change, const std::string& text) {
  const Free craft = free(body);
  const auto start = start_of(craft, body.exact(0.0), {7e6, 0.0, 0.0}, {0.0, 7500.0, 0.0});
  for (const AttitudeState attitude : {AttitudeState::quaternion, AttitudeState::dcm}) {
    CraftPropagation how = until(1.0);
    how.attitude = attitude;
    change(how);
    expect_bad_input([&] { propagate(scenario(craft), start, how); },
                     "propagate " + frame_name<Body>() + ": " + text);
  }
}

TEST(RefusedCraftPropagation, tolerances_that_are_not_positive) {
  const auto text = [](const std::string& name, const std::string& value) {
    return name + " must be finite and greater than 0, got " + value;
  };
  const auto absolute = [](auto change) {
    return [change](CraftPropagation& how) { change(how.absolute_tolerances); };
  };
  const std::string left_out = "relative_tolerance is left out, or 0; it has no default";
  expect_refused_run([](auto& how) { how.relative_tolerance = CraftPropagation{}.relative_tolerance; },
                     left_out);
  expect_refused_run([](auto& how) { how.relative_tolerance = -1.0; }, text("relative tolerance", "-1"));
  expect_refused_run(absolute([](auto& by) { by.angle = -1e-12 * si::radian; }), "absolute tolerance of ");
  expect_refused_run(absolute([](auto& by) { by.rate = nan * (si::radian / si::second); }),
                     text("absolute tolerance of wx", "nan"));
  expect_refused_run(absolute([](auto& by) { by.length = infinity * si::metre; }),
                     text("absolute tolerance of rx", "inf"));

  const Free craft = free(body);
  const auto start = start_of(craft, body.exact(0.0), {7e6, 0.0, 0.0}, {0.0, 7500.0, 0.0});
  CraftPropagation how = until(1.0);
  how.absolute_tolerances.velocity = {};
  expect_bad_input(
      [&] { propagate(scenario(craft), start, how); },
      "of the craft of \"" + frame_name<Body>() + "\": .velocity is left out, or 0; none has a default");
}

TEST(RefusedCraftPropagation, times_that_make_no_sense) {
  for (const double end : {nan, infinity, -1.0, 0.0})
    expect_refused_run([&](auto& how) { how.end = seconds(end); },
                       "the end is " + detail::text(end) + " s, the start 0 s");
  expect_refused_run([](auto& how) { how.end = CraftPropagation{}.end; },
                     "the end is 0 s, the start 0 s; .end is left out, or 0, and has no default");
  expect_refused_run(
      [](auto& how) {
        how.output_times = {seconds(0.5), seconds(0.5)};
      },
      "output times must increase strictly, but number 1 = 0.5 follows 0.5");
  expect_refused_run(
      [](auto& how) {
        how.output_times = {seconds(0.5), seconds(1.5)};
      },
      "output time 1.5 is outside [0, 1]");
  expect_refused_run([](auto& how) { how.maximum_step = seconds(0.0); },
                     "maximum_step must be greater than 0, got 0");
  expect_refused_run([](auto& how) { how.max_steps = 0; }, "max_steps must be greater than 0");
}

// Doors that take a function take a std::function too, which may hold none.
TEST(RefusedScenario, a_function_that_holds_none) {
  const Turning craft = turning(body);
  const std::function<double(const Now<Turning>&)> no_zero;
  const std::function<void(const Now<Turning>&, Forces<Turning>&)> no_load;
  const std::function<int(const Now<Turning>&)> no_change;
  const auto said = [](const auto& door) -> std::string {
    try {
      (void)door();
    } catch (const BadInput& refused) {
      return refused.what();
    }
    return "nothing";
  };
  const auto any = ode::Direction::any;
  EXPECT_EQ(said([&] { return when("eclipse", no_zero, any); }), "when(\"eclipse\"): the function is empty");
  EXPECT_EQ(said([&] { return when("eclipse", no_zero, any, stop); }),
            "when(\"eclipse\"): the function is empty");
  EXPECT_EQ(said([&] {
              return when(
                  "eclipse", [](const Now<Turning>&) { return 1.0; }, any, no_change);
            }),
            "when(\"eclipse\"): the function is empty");
  EXPECT_EQ(said([&] { return every(seconds(1.0), no_change); }), "every: the function is empty");
  EXPECT_EQ(said([&] { return at_times({seconds(1.0)}, no_change); }), "at_times: the function is empty");
  EXPECT_EQ(said([&] { return at_start(no_change); }), "at_start: the function is empty");
  EXPECT_EQ(said([&] { return scenario(craft, no_load); }), "scenario, a load: the function is empty");
  const auto held_load = [](const Now<Turning>&, Forces<Turning>&) {};
  EXPECT_EQ(said([&] {
              return scenario(craft, std::function<void(const Now<Turning>&, Forces<Turning>&)>(held_load));
            }),
            "nothing");
}

}  // namespace
}  // namespace vectrix::test::rigid_refusals_test
