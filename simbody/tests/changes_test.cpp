#include <gtest/gtest.h>

#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vectrix/simbody.hpp>

#include "craft/random_spacecraft.hpp"

// What our loop does around Simbody: held values, ticks, zeros, locks, friction; failures and refusals.
namespace vectrix_test::spacecraft_test::simbody_changes_test {
namespace {

using namespace vectrix;
using spacecraft_test::Gcrf;

/// The accuracy of these runs, and what their differences may be: some hundred steps that each add it.
constexpr double accuracy = 1e-9, close = 1e-6;

const Turning craft;
using Sat = Turning;

auto start() {
  const auto still = moving_dcm(
      aligned(to<Gcrf>, from<Hub>),
      angular_velocity(of<Hub>, relative_to<Gcrf>, vector(in<Hub>, 0.1 * rad_s, -0.2 * rad_s, 0.05 * rad_s)));
  return state(craft, 1.0 * s, still, starts(of<Boom>, 0.2 * rad, 0.4 * rad_s),
               spins(of<WheelOfHub>, 20.0 * rad_s));
}
CraftPropagation ours_until(double end) {
  return {.end = end * s,
          .relative_tolerance = 1e-12,
          .absolute_tolerances = {1e-12 * rad, 1e-12 * rad_s, 1e-12 * m, 1e-12 * m_s, 1e-12}};
}
SimbodyPropagation until(double end) {
  return {.end = end * s, .accuracy = accuracy};
}
void expect_close(const CraftComparison<Sat>& found) {
  EXPECT_LT(found.attitude(of<Hub>).size.value(), close);
  EXPECT_LT(found.rate(of<Hub>).size.value(), close);
  EXPECT_LT(found.coordinate(of<Boom>).size.value(), close);
  EXPECT_LT(found.speed(of<Boom>).size.value(), close);
  EXPECT_LT(found.spin(of<WheelOfHub>).size.value(), close);
}

struct Command {
  double torque;
};
const auto turn_wheel = [](const Now<Sat>&, Forces<Sat>& forces, const Command& command) {
  forces.motor(of<WheelOfHub>, command.torque * N_m);
};
const auto damp = [](const Now<Sat>& now, Forces<Sat>& forces) {
  forces.effort(of<Boom>, -0.5 * now.coordinate(of<Boom>).value() * N_m);
};
const auto controller = every(0.25 * s, [](const Now<Sat>& now, const Command&) {
  return Command{0.3 * now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>).z().value()};
});

TEST(SimbodyRun, ticks_when_ours_does_and_holds_the_same) {
  const auto flight = scenario(craft, turn_wheel, damp, held(Command{0.0}), controller);
  const auto ours = propagate(flight, start(), ours_until(5.1));
  const auto theirs = propagate_with_simbody(flight, start(), until(5.1));
  expect_close(compare(craft, ours, theirs));
  for (const double t : {1.0, 1.2, 1.25, 3.6, 5.1})
    EXPECT_NEAR(theirs.held<Command>(t * s).torque, ours.held<Command>(t * s).torque, close) << t;
  EXPECT_NE(theirs.held<Command>(5.0 * s).torque, 0.0);
  EXPECT_EQ(theirs.solution().segment_count(), ours.solution().segment_count());
}

TEST(SimbodyRun, finds_the_zeros_of_ours_and_stops_at_them) {
  const auto angle = [](const Now<Sat>& now) { return now.coordinate(of<Boom>); };
  const auto flight = scenario(
      craft, turn_wheel, damp, held(Command{0.0}),
      when("boom at zero", angle, ode::Direction::any, becomes(Command{0.4})),
      when(
          "boom far", [](const Now<Sat>& now) { return std::abs(now.coordinate(of<Boom>).value()) - 0.8; },
          ode::Direction::rising, stop));
  const auto ours = propagate(flight, start(), ours_until(60.0));
  const auto theirs = propagate_with_simbody(flight, start(), until(60.0));
  EXPECT_TRUE(ours.stopped());
  EXPECT_TRUE(theirs.stopped());
  const auto found = compare(craft, ours, theirs);
  expect_close(found);
  ASSERT_TRUE(found.events());
  EXPECT_LT(found.events()->size.value(), close);
}

struct Lock {
  bool on;
};
TEST(SimbodyRun, locks_a_joint_and_a_rotor_while_ours_does) {
  const auto flight = scenario(
      craft, damp,
      [](const Now<Sat>&, Forces<Sat>& forces, const Lock& lock) {
        forces.motor(of<WheelOfHub>, 0.3 * N_m);
        if (lock.on) {
          forces.lock(of<Boom>);
          forces.lock(of<WheelOfHub>);
        }
      },
      held(Lock{false}), at_times({2.0 * s}, becomes(Lock{true})), at_times({3.0 * s}, becomes(Lock{false})));
  const auto ours = propagate(flight, start(), ours_until(4.0));
  const auto theirs = propagate_with_simbody(flight, start(), until(4.0));
  expect_close(compare(craft, ours, theirs));
  const auto spin = [&](double t) { return theirs.at(t * s).spin(of<WheelOfHub>).value(); };
  EXPECT_NEAR(spin(3.0), spin(2.0), 1e-12);
  EXPECT_GT(std::abs(spin(4.0) - spin(3.0)), close);
  const auto speed = [&](double t) { return theirs.at(t * s).speed(of<Boom>).value(); };
  EXPECT_NEAR(speed(2.9), speed(2.0), 1e-12);
}

// The impulses are ours; what moves after them is theirs.
TEST(SimbodyRun, is_latched_where_ours_is) {
  const auto flight = scenario(craft, damp, lockable(craft, of<Boom>), lockable(craft, of<WheelOfHub>),
                               at_times({1.5 * s}, becomes(Locked<Boom>{true})),
                               at_times({2.5 * s}, becomes(Locked<WheelOfHub>{true})));
  const auto ours = propagate(flight, start(), ours_until(4.0));
  const auto theirs = propagate_with_simbody(flight, start(), until(4.0));
  expect_close(compare(craft, ours, theirs));
  EXPECT_NE(theirs.at(1.4 * s).speed(of<Boom>).value(), 0.0);
  EXPECT_EQ(theirs.at(4.0 * s).speed(of<Boom>).value(), 0.0);
  EXPECT_EQ(theirs.at(4.0 * s).spin(of<WheelOfHub>).value(), 0.0);
}

TEST(SimbodyRun, sticks_and_slips_as_ours) {
  const auto flight = scenario(
      craft, damp,
      friction(craft, of<Boom>, 0.05 * N_m, 0.08 * N_m, 0.01 * rad_s, 0.0 * (si::newton_metre / rad_s)));
  const auto ours = propagate(flight, start(), ours_until(20.0));
  const auto theirs = propagate_with_simbody(flight, start(), {.end = 20.0 * s, .accuracy = 0.1 * accuracy});
  const auto found = compare(craft, ours, theirs);
  expect_close(found);
  ASSERT_TRUE(found.events());
  EXPECT_GT(ours.events().size(), 1U);
  for (double t = 1.0; t <= 20.0; t += 0.5)
    EXPECT_EQ(theirs.at(t * s).speed(of<Boom>).value() == 0.0, ours.at(t * s).speed(of<Boom>).value() == 0.0)
        << t;
}

template <class F> std::string message_of(const F& run) {
  try {
    run();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}
void expect_says(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(SimbodyRun, that_fails_keeps_the_trajectory_and_what_was_thrown) {
  const auto flight = scenario(craft, [](const Now<Sat>& now, Forces<Sat>&) {
    if (now.time() > 3.0 * s) throw std::domain_error("beyond the table");
  });
  try {
    (void)propagate_with_simbody(flight, start(), until(5.0));
    FAIL();
  } catch (const CraftFailure<Sat>& failure) {
    EXPECT_GT(failure.trajectory().end(), 2.0 * s);
    EXPECT_LE(failure.trajectory().end(), 3.0 * s);
    EXPECT_EQ(failure.flag(), -8);
    expect_says(failure.what(), "propagate_with_simbody");
    expect_says(failure.what(), "beyond the table");
  }
}

TEST(SimbodyRun, says_which_load_is_no_number) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto run = [&](const auto& load) {
    return message_of([&] { (void)propagate_with_simbody(scenario(craft, load), start(), until(5.0)); });
  };
  const auto about = [&](const auto& f) {
    return
        [nan, f](const Now<Sat>& now, Forces<Sat>& forces) { f(forces, now.time() > 2.0 * s ? nan : 0.0); };
  };
  expect_says(run(about([](Forces<Sat>& f, double x) { f.motor(of<WheelOfHub>, x * N_m); })),
              "load 1 of 1: the motor torque on vectrix_test");
  expect_says(run(about([](Forces<Sat>& f, double x) { f.effort(of<Boom>, x * N_m); })),
              "load 1 of 1: the effort on the joint of");
  expect_says(run([](const Now<Sat>&, Forces<Sat>& f) {
                const auto most = vector(in<Hub>, 1.5e308 * N, 0.0 * N, 0.0 * N);
                f.force(of<Boom>, most);
                f.force(of<Boom>, most);
              }),
              "load 1 of 1: the force on");
}

// A load decides by the time, without a held value: the steps of both cross the ends of the lock, and the
// states at the ends of the runs are compared, as no polynomial over such a step is right.
TEST(SimbodyRun, locks_and_frees_within_a_segment) {
  const auto locked_between = [](double begin, double end) {
    return scenario(craft, damp, [begin, end](const Now<Sat>& now, Forces<Sat>& forces) {
      forces.motor(of<WheelOfHub>, 0.3 * N_m);
      if (!(now.time() > begin * s && now.time() < end * s)) return;
      forces.lock(of<Boom>);
      forces.lock(of<WheelOfHub>);
    });
  };
  for (const double begin : {0.0, 2.0})
    for (const double end : {2.9, 4.0}) {
      const auto flight = locked_between(begin, 3.0);
      const auto ours = propagate(flight, start(), ours_until(end));
      const auto theirs = propagate_with_simbody(flight, start(), until(end));
      EXPECT_EQ(theirs.solution().segment_count(), 1U);
      for (std::size_t i = 0; i < Sat::state_size; ++i)
        EXPECT_NEAR(theirs.at(end * s).numbers()[i], ours.at(end * s).numbers()[i], close) << i;
      const double gained = (theirs.at(end * s).speed(of<Boom>) - start().speed(of<Boom>)).value();
      EXPECT_EQ(gained == 0.0, begin == 0.0 && end == 2.9) << gained;
    }
}

TEST(SimbodyRun, moves_a_prescribed_joint_as_ours) {
  const auto swing = [](const Quantity<si::time>& t) {
    const double phase = 2.0 * (t.value() - 1.0);
    return JointMotion{(0.2 + 0.2 * std::sin(phase)) * rad, 0.4 * std::cos(phase) * rad_s,
                       -0.8 * std::sin(phase) * (rad_s / s)};
  };
  const auto flight =
      scenario(craft, damp, prescribed(craft, of<Boom>, swing), turn_wheel, held(Command{0.1}), controller);
  const auto ours = propagate(flight, start(), ours_until(4.0));
  const auto theirs = propagate_with_simbody(flight, start(), until(4.0));
  expect_close(compare(craft, ours, theirs));
  for (const double t : {1.7, 2.9, 4.0})
    EXPECT_NEAR(theirs.at(t * s).coordinate(of<Boom>).value(), swing(t * s).coordinate.value(), close);
}

TEST(SimbodyRun, ends_after_the_most_steps) {
  auto how = until(5.0);
  how.max_steps = 7;
  expect_says(message_of([&] { (void)propagate_with_simbody(scenario(craft), start(), how); }),
              "max_steps = 7");
}

TEST(SimbodyRun, refuses_what_is_no_run) {
  const auto says = [&](const SimbodyPropagation& how, const char* part) {
    EXPECT_THROW((void)propagate_with_simbody(scenario(craft), start(), how), BadInput);
    expect_says(message_of([&] { (void)propagate_with_simbody(scenario(craft), start(), how); }), part);
  };
  for (const double bad : {0.0, 1.0, -1e-6, std::numeric_limits<double>::quiet_NaN()})
    says({.end = 5.0 * s, .accuracy = bad}, "the accuracy must be between 0 and 1");
  says({.end = 5.0 * s, .accuracy = SimbodyPropagation{}.accuracy},
       "it is left out, or 0, and has no default");
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    says({.end = 5.0 * s, .accuracy = 1e-6, .time_scale = bad * s}, "the time scale");
  says({.end = 1.0 * s, .accuracy = 1e-6}, "the end is 1 s, the start 1 s");
  says({.end = 5.0 * s, .accuracy = 1e-6, .maximum_step = 0.0 * s}, "maximum_step");
  says({.end = 5.0 * s, .accuracy = 1e-6, .output_times = {6.0 * s}}, "output time 6");
}

// A plate has J_zz = J_xx + J_yy; less a disc about x it has less about x and y, and is no body.
TEST(SimbodyRun, names_a_body_that_is_too_flat_for_its_wheel) {
  RandomCraft random(12);
  const auto plate =
      mass_properties(3.0 * si::kilogram, coincident(of<CentreOfMassOf<Boom>>, relative_to<Boom>, in<Boom>),
                      inertia_from_principal_moments(in<Boom>, 1.0 * kg_m2, 2.0 * kg_m2, 3.0 * kg_m2));
  const auto flat = spacecraft(body(mass<Hub>(random, 10.0), turning_in<Gcrf>),
                               body(plate, hinge(place<Hub, Boom>(random), unit_x(in<Boom>))),
                               rotor(of<WheelOfBoom>, unit_x(in<Boom>), 0.1 * kg_m2));
  const auto rest = state(flat, 0.0 * s, moving<Gcrf, Hub>(random).turning,
                          starts(of<Boom>, 0.0 * rad, 0.0 * rad_s), spins(of<WheelOfBoom>, 0.0 * rad_s));
  const auto run = [&] { (void)propagate_with_simbody(scenario(flat), rest, until(1.0)); };
  EXPECT_THROW(run(), BadInput);
  expect_says(message_of(run),
              "Simbody refuses the craft: " + frame_name<Boom>() + " less the discs of its rotors: ");
}

}  // namespace
}  // namespace vectrix_test::spacecraft_test::simbody_changes_test
