#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vectrix/dynamics/load/springs.hpp>
#include <vectrix/dynamics/load/thruster.hpp>

#include "load/three_parts.hpp"

// A thruster that rises and falls, against the integral of its thrust.
namespace vectrix_test::three_parts::thruster_test {
namespace {

constexpr double rounding = 1e-12;  // of numbers near 1, in some ten steps
constexpr double F = 1.8, rise = 0.05, fall = 0.08;
const ThrustResponse response{rise * s, fall* s};

double velocity_of(const CraftState<Sat>& state) {
  return state.hub_motion().velocity.y().value();
}

/// The impulse until t of intervals [on, off], the thrust at the first being 0, by the exponentials.
double impulse(double t, const std::vector<std::array<double, 2>>& intervals) {
  double x = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const auto [on, off] = intervals[i];
    if (t <= on) break;
    const double burn = std::min(t, off) - on;
    sum += burn - (1.0 - x) * rise * -std::expm1(-burn / rise);
    x = 1.0 - (1.0 - x) * std::exp(-burn / rise);
    if (t <= off) break;
    const double end = i + 1 < intervals.size() ? std::min(t, intervals[i + 1][0]) : t;
    sum += x * fall * -std::expm1(-(end - off) / fall);
    x *= std::exp(-(end - off) / fall);
  }
  return F * sum;
}
const std::vector<std::array<double, 2>> train{{0.5, 0.52}, {0.6, 1.3}, {1.35, 1.36}, {2.0, 2.5}};
std::vector<FiringInterval> intervals() {
  std::vector<FiringInterval> all;
  for (const auto& each : train) all.push_back({each[0] * s, each[1] * s});
  return all;
}

// Through the common centre of mass: the momentum is the impulse. Runs that start before, in and after an
// interval.
TEST(Thruster, TheMomentumIsTheImpulse) {
  const Sat sat;
  const auto fired =
      scenario(sat, thruster(sat, of<Hub>, F * N * unit_y(in<Inertial>), response, intervals()));
  for (const double begin : {0.0, 0.5, 0.51, 1.3, 1.32, 2.2, 2.7}) {
    const auto flight = propagate(fired, start_of(sat, {.time = begin}), until(3.0));
    for (double t = begin; t <= 3.0; t += 0.11) {
      EXPECT_NEAR((m_hub + m_panel + m_mass) * velocity_of(flight.at(t * s)),
                  impulse(t, train) - impulse(begin, train), rounding)
          << begin << ' ' << t;
      EXPECT_NEAR(flight.held<Firing<Hub>>(t * s).impulse(t * s).value(), impulse(t, train), rounding)
          << begin << ' ' << t;
    }
    EXPECT_FALSE(flight.held<Firing<Hub>>(3.0 * s).is_on());
  }
  EXPECT_TRUE(propagate(fired, start_of(sat, {}), until(3.0)).held<Firing<Hub>>(0.5 * s).is_on());
}

// With one time constant the rest of each fall makes up for its rise: the impulse is the full thrust times
// all the time on, whatever else changes and happens in the run.
TEST(Thruster, ALongTrainIsBookedThroughEvents) {
  const Sat sat;
  constexpr int pulses = 200;
  constexpr double end = 20.0, constant = 0.05;
  std::vector<FiringInterval> pulse_train;
  double on = 0.0;
  for (int i = 0; i < pulses; ++i) {
    const double begin = 0.07 * i + 0.003 * (i % 5), length = 0.01 + 0.004 * (i % 9);
    pulse_train.push_back({begin * s, (begin + length) * s});
    on += (pulse_train.back().end - pulse_train.back().start).value();
  }
  struct Sampled {
    int count;
  };
  const auto swings = [](const Now<Sat>& now) { return now.speed(of<Panel>); };
  const auto flight = propagate(
      scenario(
          sat,
          thruster(sat, of<Hub>, F * N * unit_y(in<Inertial>), {constant * s, constant * s}, pulse_train),
          spring(sat, of<Panel>, 20.0 * N_m / rad, 0.0 * rad), held(Sampled{0}),
          every(0.13 * s, [](const Now<Sat>&, const Sampled& last) { return Sampled{last.count + 1}; }),
          when("the panel turns back", swings, ode::Direction::any,
               [](const Now<Sat>&, const Sampled& last) { return Sampled{last.count + 1}; })),
      start_of(sat, {.angle = 0.3}), until(end));
  EXPECT_GT(flight.events().size(), 20U);
  // Each switch rounds a time and a sum of times.
  constexpr double of_switches = F * 2 * pulses * end * std::numeric_limits<double>::epsilon();
  const auto booked = flight.held<Firing<Hub>>(end * s);
  EXPECT_EQ(booked.switches(), 2U * pulses);
  EXPECT_NEAR(booked.impulse(end * s).value(), F * on, of_switches);
  // Each of some thousand steps rounds the velocity.
  const auto at_end = motion(sat, flight.at(end * s));
  EXPECT_NEAR(at_end.now().momentum().y().value(), F * on, 1e3 * rounding);
}

// Without time constants it is a pulse; on a mount it acts through the mount's origin.
TEST(Thruster, AtOnceItIsAPulse) {
  const Sat sat;
  const auto force = vector(in<Nozzle>, 0.4 * N, 0.5 * N, -0.6 * N);
  const ThrustResponse at_once{0.0 * s, 0.0 * s};
  const auto start = start_of(sat, {.rate = 0.3, .hub_rate = 0.1});
  const auto fired = propagate(scenario(sat, thruster(sat, of<Nozzle>, force, at_once, {{1.0 * s, 2.0 * s}})),
                               start, until(3.0))
                         .at(3.0 * s);
  const auto pushed = scenario(
      sat, held(true),
      [&](const Now<Sat>&, Forces<Sat>& forces, const bool& on) {
        if (on) forces.force(of<Nozzle>, force);
      },
      at_times({0.0 * s, 2.0 * s}, becomes(false)), at_times({1.0 * s}, becomes(true)));
  const auto wanted = propagate(pushed, start, until(3.0)).at(3.0 * s);
  for (std::size_t i = 0; i < Sat::state_size; ++i)
    EXPECT_NEAR(fired.numbers()[i], wanted.numbers()[i], 10 * rounding) << i;
}

TEST(Thruster, RefusesBadInput) {
  const Sat sat;
  const auto complaint = [&](const ThrustResponse& with, const std::vector<FiringInterval>& when) {
    return message<BadInput>([&] { thruster(sat, of<Hub>, F * N * unit_y(in<Hub>), with, when); });
  };
  EXPECT_EQ(complaint({-1.0 * s, 0.0 * s}, intervals()),
            "thruster: the time constant of the rise is -1 s; it must not be negative");
  EXPECT_EQ(complaint(response, {}), "thruster: no interval");
  EXPECT_EQ(complaint(response, {{1.0 * s, 2.0 * s}, {2.0 * s, 3.0 * s}}),
            "thruster: the switch at 2 s follows that at 2 s");
  EXPECT_EQ(complaint(response, {{1.0 * s, std::numeric_limits<double>::infinity() * s}}),
            "thruster: the time of a switch is inf s");
}

}  // namespace
}  // namespace vectrix_test::three_parts::thruster_test
