#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "methods.hpp"
#include "short_units.hpp"
#include "testing/attitudes.hpp"

// Held values: sampled, switched, delayed. The craft is one body that only turns, about its axis z, so that
// its motion between two changes is known.
namespace vectrix::craft_scenario_test {
namespace {

using namespace vectrix_test::short_units;
using vectrix_test::message;

struct Inertial : inertial_frame {};
struct Hub : moving_frame {};

constexpr double J = 2.0;  // kg m^2, about z

auto make_sat() {
  return spacecraft(
      body(mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                           inertia_from_principal_moments(in<Hub>, 1.5 * kg_m2, 1.5 * kg_m2, J * kg_m2)),
           turning_in<Inertial>));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};
using OnSat = Now<Sat>;
using ForcesOnSat = Forces<Sat>;
// What needs the accelerations is never given an instant without them.
static_assert(!std::is_convertible_v<OnSat, detail::Solved<Sat, int>>);

CraftState<Sat> spinning(const Sat& sat, double rate, double start = 0.0) {
  return state(sat, start * s,
               moving_dcm(aligned(to<Inertial>, from<Hub>),
                          angular_velocity(of<Hub>, relative_to<Inertial>, rate * rad_s * unit_z(in<Hub>))));
}
CraftPropagation until(double end, ode::Method method = ode::Method::verner_9) {
  return {
      .end = end * s,
      .relative_tolerance = 1e-13,
      .absolute_tolerances = {1e-13 * rad, 1e-13 * rad_s, 1e-13 * si::metre, 1e-13 * (si::metre / s), 1e-13},
      .method = method};
}
double rate_of(const OnSat& now) {
  return now.angular_velocity(of<Hub>, relative_to<Inertial>, in<Hub>).z().value();
}
double rate_of(const CraftState<Sat>& state) {
  return state.turning().angular_velocity.z().value();
}

constexpr double rounding = 1e-14;  // of some twenty steps of numbers up to 1

struct Command {
  Quantity<si::torque> torque;
};
const auto by_command = [](const OnSat&, ForcesOnSat& forces, const Command& command) {
  forces.torque(of<Hub>, command.torque.value() * N_m * unit_z(in<Hub>));
};

// J w' = -K w(kT): w(kT + t) = (1 - K t/J) w(kT), also where the ticks of two clocks round differently.
TEST(CraftScenario, ASampledControllerHoldsItsCommand) {
  const Sat sat;
  constexpr double K = 3.0, T = 0.1;
  int ticks = 0;
  const auto loop = scenario(sat, held(Command{9.0 * N_m}), by_command, every(T * s, [&](const OnSat& now) {
                               ++ticks;
                               return Command{-K * rate_of(now) * N_m};
                             }));
  const auto flight = propagate(loop, spinning(sat, 0.4), until(2.0));
  EXPECT_EQ(ticks, 20);
  EXPECT_EQ(flight.solution().segment_count(), 20U);
  double w = 0.4;
  for (int k = 0; k < 20; ++k) {
    EXPECT_NEAR(rate_of(flight.at((k * T + 0.05) * s)), (1.0 - K * 0.05 / J) * w, rounding);
    EXPECT_NEAR(flight.held<Command>((k * T + 0.05) * s).torque.value(), -K * w, rounding * K);
    w *= 1.0 - K * T / J;
  }
  EXPECT_EQ(flight.held<Command>(0.0 * s).torque.value(), -K * 0.4);
}

// w_k+1 = w_k + u_k-1 T/J: the command is the one from a sample before.
TEST(CraftScenario, ALatencyDelaysWhatWasSeen) {
  const Sat sat;
  constexpr double K = 3.0, T = 0.25, latency = 0.375;
  const auto loop =
      scenario(sat, held(Command{0.0 * N_m}), by_command,
               every(
                   T * s, [&](const OnSat& now) { return Command{-K * rate_of(now) * N_m}; }, latency * s));
  const auto flight = propagate(loop, spinning(sat, 0.4), until(3.0));
  std::vector<double> seen;
  double w = 0.4;
  const auto command = [&](int k) { return k < 0 ? 0.0 : -K * seen[static_cast<std::size_t>(k)]; };
  for (int k = 0; k < 12; ++k) {
    EXPECT_NEAR(rate_of(flight.at(k * T * s)), w, rounding);
    seen.push_back(w);
    // In the first half of the interval the command of two samples before acts, then that of one before.
    w += 0.5 * T / J * (command(k - 2) + command(k - 1));
  }
  EXPECT_EQ(flight.held<Command>(0.3 * s).torque.value(), 0.0);
  EXPECT_EQ(flight.held<Command>(latency * s).torque.value(), -K * 0.4);
}

enum class Mode { forward, backward };
const auto by_mode = [](const OnSat&, ForcesOnSat& forces, const Mode& mode) {
  forces.torque(of<Hub>, (mode == Mode::forward ? 1.0 : -1.0) * N_m * unit_z(in<Hub>));
};

// J w' = 1 N m until w = 1/2 rad/s, then -1 N m until w = -1/2: a sawtooth. All methods.
TEST(CraftScenario, AZeroSwitchesAMode) {
  const Sat sat;
  const auto toggle = scenario(sat, held(Mode::forward), by_mode,
                               when(
                                   "fast", [](const OnSat& now) { return rate_of(now) - 0.5; },
                                   ode::Direction::rising, becomes(Mode::backward)),
                               when(
                                   "slow", [](const auto& now) { return (rate_of(now) + 0.5) * rad_s; },
                                   ode::Direction::falling, [](const OnSat&) { return Mode::forward; }));
  for (const ode::Method method : vectrix_test::methods) {
    SCOPED_TRACE(vectrix_test::name_of(method));
    const auto flight = propagate(toggle, spinning(sat, 0.0), until(12.0, method));
    const auto events = flight.events();
    ASSERT_EQ(events.size(), 6U);
    // 6 segments with 1e-13 in each of some 15 steps; of Adams some 1500.
    const double within = 6 * 1e-13 * (method == ode::Method::cvode_adams ? 1500 : 15);
    for (std::size_t i = 0; i < events.size(); ++i) {
      EXPECT_EQ(events[i].name, i % 2 == 0 ? "fast" : "slow");
      EXPECT_NEAR(events[i].state.time().value(), 1.0 + 2.0 * static_cast<double>(i), within);
      EXPECT_NEAR(rate_of(events[i].state), i % 2 == 0 ? 0.5 : -0.5, within);
      EXPECT_EQ(flight.held<Mode>(events[i].state.time()), i % 2 == 0 ? Mode::backward : Mode::forward);
    }
    EXPECT_FALSE(flight.stopped());
  }
}

// Changes at one instant see the values from before; of two that change one value the later counts.
struct First {
  int value;
};
struct Second {
  int value;
};
TEST(CraftScenario, ChangesAtOneInstantSeeWhatWasBefore) {
  const Sat sat;
  const auto swapped =
      scenario(sat, held(First{1}), held(Second{2}),
               at_times({1.0 * s}, [](const OnSat&, const Second& second) { return First{second.value}; }),
               at_times({1.0 * s}, [](const OnSat&, const First& first) { return Second{first.value}; }),
               when(
                   "two", [](const OnSat& now) { return now.time() - 2.0 * s; }, ode::Direction::rising,
                   becomes(First{7})),
               at_times({2.0 * s}, becomes(First{8})));
  const auto flight = propagate(swapped, spinning(sat, 0.1), until(3.0));
  EXPECT_EQ(flight.held<First>(0.5 * s).value, 1);
  EXPECT_EQ(flight.held<First>(1.0 * s).value, 2);
  EXPECT_EQ(flight.held<Second>(1.0 * s).value, 1);
  EXPECT_EQ(flight.held<First>(2.0 * s).value, 8);
  EXPECT_EQ(flight.solution().segment_count(), 3U);
}

// 3 * 0.1 is not 0.3 in doubles: both clocks tick at one instant all the same.
TEST(CraftScenario, ClocksThatRoundDifferentlyTickTogether) {
  const Sat sat;
  std::vector<double> slow, fast;
  const auto clocks = scenario(sat, held(First{0}), held(Second{0}),
                               every(0.1 * s,
                                     [&](const OnSat& now) {
                                       fast.push_back(now.time().value());
                                       return First{static_cast<int>(fast.size())};
                                     }),
                               every(0.3 * s, [&](const OnSat& now, const First& first) {
                                 slow.push_back(now.time().value());
                                 return Second{first.value};
                               }));
  const auto flight = propagate(clocks, spinning(sat, 0.1), until(3.0));
  ASSERT_EQ(fast.size(), 30U);
  ASSERT_EQ(slow.size(), 10U);
  for (std::size_t k = 0; k < slow.size(); ++k) EXPECT_EQ(slow[k], fast[3 * k]);
  EXPECT_EQ(flight.held<Second>(2.8 * s).value, 27);  // what the fast clock held before its tick number 28
  EXPECT_EQ(flight.solution().segment_count(), 30U);
}

// Of times that differ by a rounding the later one counts, at once.
TEST(CraftScenario, TimesThatDifferByARoundingAreOneInstant) {
  const Sat sat;
  const double just_after = std::nextafter(1.0, 2.0);
  const auto twice = scenario(sat, held(First{0}), at_times({1.0 * s}, becomes(First{1})),
                              at_times({1.0 * s, just_after * s}, becomes(First{2})));
  const auto flight = propagate(twice, spinning(sat, 0.1), until(2.0));
  EXPECT_EQ(flight.held<First>(0.5 * s).value, 0);
  EXPECT_EQ(flight.held<First>(1.0 * s).value, 2);
  EXPECT_EQ(flight.solution().segment_count(), 2U);
}

// A torque that depends on time, sampled state: with a step across each change the order would be 1.
TEST(CraftScenario, TheOrderOfTheMethodIsKept) {
  const Sat sat;
  // J w' = sin t + u, u = -cos(2 t_k) since the last tick: w in closed form.
  const auto loop = scenario(
      sat, held(Command{0.0 * N_m}),
      [](const OnSat& now, ForcesOnSat& forces, const Command& command) {
        forces.torque(of<Hub>,
                      (std::sin(now.time().value()) + command.torque.value()) * N_m * unit_z(in<Hub>));
      },
      every(0.7 * s, [](const OnSat& now) { return Command{-std::cos(2.0 * now.time().value()) * N_m}; }));
  const auto exact = [](double t) {
    double w = 0.1 + (1.0 - std::cos(t)) / J;
    for (int k = 0; k * 0.7 < t; ++k) w -= std::cos(1.4 * k) * std::min(0.7, t - 0.7 * k) / J;
    return w;
  };
  struct Run {
    double error;
    std::size_t steps;
  };
  const auto run = [&](double tolerance) {
    auto how = until(10.0, ode::Method::verner_7);
    how.relative_tolerance = tolerance;
    how.absolute_tolerances.rate = tolerance * rad_s;
    how.absolute_tolerances.angle = tolerance * rad;
    const auto flight = propagate(loop, spinning(sat, 0.1), how);
    double worst = 0.0;
    for (double t = 0.05; t < 10.0; t += 0.1)
      worst = std::max(worst, std::abs(rate_of(flight.at(t * s)) - exact(t)));
    return Run{worst, flight.solution().statistics().steps};
  };
  constexpr std::size_t segments = 15;
  const Run coarse = run(1e-6), fine = run(1e-12);
  EXPECT_LT(coarse.error, 1e-6 * segments);
  EXPECT_LT(fine.error, 1e-12 * segments);
  // Of order 7, and one more step in each segment, which has no part of one. Of order 1 a million times.
  EXPECT_LE(static_cast<double>(fine.steps),
            std::pow(1e6, 1.0 / 7.0) * static_cast<double>(coarse.steps) + segments);
}

TEST(CraftScenario, AStopEndsTheRun) {
  const Sat sat;
  const auto braked =
      scenario(sat, held(Command{-1.0 * N_m}), by_command,
               when(
                   "slow", [](const OnSat& now) { return rate_of(now) - 0.2; }, ode::Direction::any),
               when(
                   "at rest", [](const OnSat& now) { return rate_of(now); }, ode::Direction::falling, stop));
  const auto flight = propagate(braked, spinning(sat, 0.5), until(9.0));
  EXPECT_TRUE(flight.stopped());
  EXPECT_NEAR(flight.end().value(), 1.0, rounding);
  ASSERT_EQ(flight.events().size(), 2U);
  EXPECT_NEAR(flight.events()[0].state.time().value(), 0.6, rounding);
  EXPECT_EQ(flight.events()[1].name, "at rest");
}

// Inside the run the torque on the hub is that of the command held then.
TEST(CraftScenario, AMotionHasTheLoadsOfItsTime) {
  const Sat sat;
  const auto pulse =
      scenario(sat, held(Command{0.0 * N_m}), at_times({1.0 * s}, becomes(Command{0.5 * N_m})), by_command);
  const auto flight = propagate(pulse, spinning(sat, 0.5), until(2.0));
  const auto alpha = [&](double t) {
    return motion_at(pulse, flight, t * s).angular_acceleration(of<Hub>, in<Hub>).z().value();
  };
  EXPECT_EQ(alpha(0.5), 0.0);
  EXPECT_NEAR(alpha(1.0), 0.5 / J, rounding);
}

TEST(CraftScenario, WhatACommandThrowsArrivesWithTheTrajectory) {
  const Sat sat;
  const auto broken =
      scenario(sat, held(Command{0.1 * N_m}), by_command, every(0.5 * s, [](const OnSat& now) {
                 if (now.time() > 1.2 * s) throw std::domain_error("no star in view");
                 return Command{0.2 * N_m};
               }));
  try {
    propagate(broken, spinning(sat, 0.0), until(3.0));
    FAIL() << "no failure";
  } catch (const CraftFailure<Sat, Command>& failure) {
    EXPECT_EQ(failure.time(), 1.5);
    EXPECT_NE(std::string(failure.what()).find("no star in view"), std::string::npos) << failure.what();
    EXPECT_NEAR(rate_of(failure.trajectory().at(1.5 * s)), 0.15, rounding);
    EXPECT_EQ(failure.trajectory().held<Command>(1.2 * s).torque, 0.2 * N_m);
  }
}

TEST(CraftScenario, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto one = becomes(First{1});
  EXPECT_EQ(message<BadInput>([&] { every(0.0 * s, one); }), "every: the period is 0 s; it must be positive");
  EXPECT_EQ(message<BadInput>([&] { every(nan * s, one); }),
            "every: the period is nan s; it must be positive");
  EXPECT_EQ(message<BadInput>([&] { every(1.0 * s, one, -1.0 * s); }),
            "every: the latency is -1 s; it must not be negative");
  EXPECT_EQ(message<BadInput>([&] { at_times({1.0 * s, nan * s}, one); }), "at_times: a time is nan s");
  EXPECT_EQ(message<BadInput>([&] {
              at_times({1.0 * s, 1.0 * s}, one);
            }),
            "at_times: 1 s follows 1 s; times must increase");
  const Sat sat;
  const auto start = spinning(sat, 0.1, 10.0);
  EXPECT_EQ(message<BadInput>([&] { propagate(scenario(sat), start, until(10.0)); }),
            "propagate " + frame_name<Hub>() + ": the end is 10 s, the start 10 s");
  EXPECT_EQ(message<BadInput>([&] { propagate(scenario(sat), start, until(nan)); }),
            "propagate " + frame_name<Hub>() + ": the end is nan s, the start 10 s");
  const auto fast = scenario(sat, held(First{1}), every(1e-9 * s, one));
  EXPECT_EQ(message<BadInput>([&] { propagate(fast, start, until(20.0)); }),
            "propagate: a period of 1e-09 s gives 1e+10 ticks from 10 s to 20 s, more than 1e+08");
  const auto late = scenario(sat, held(First{1}), every(1e-7 * s, one));
  EXPECT_EQ(message<BadInput>([&] { propagate(late, spinning(sat, 0.1, 1e9), until(1e9 + 1.0)); }),
            "propagate: a period of 1e-07 s is below the rounding of 1000000001 s");
  const auto flight = propagate(scenario(sat, held(First{1})), start, until(20.0));
  EXPECT_EQ(message<BadInput>([&] { flight.held<First>(9.0 * s); }),
            "CraftTrajectory::held: time 9 s is outside [10, 20] s");
}

}  // namespace
}  // namespace vectrix::craft_scenario_test
