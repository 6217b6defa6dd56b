#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/dynamics/load/stop_at.hpp>

#include "load/three_parts.hpp"

// A panel that starts at rest exactly at a stop, against the closed forms of a damped oscillator: with the
// inertia J that its hinge sees, w = (k/J)^(1/2) and z = c/(2 J w).
namespace vectrix_test::three_parts::stop_rest_test {
namespace {

constexpr double rounding = 1e-12;  // of angles below 0.5, in some hundred steps with a tolerance of 1e-13
constexpr double k = 100.0, c = 5.0, lower = -0.4, upper = 0.3, M = 3.0;
constexpr double J = 1.0 / (1.0 / J_panel + 1.0 / J_rest);
const double w = std::sqrt(k / J), z = c / (2.0 * J * w), root = std::sqrt(1.0 - z * z);
constexpr double infinite = std::numeric_limits<double>::infinity();

double limit_of(int side) {
  return side > 0 ? upper : lower;
}
double angle_of(const CraftState<Sat>& state) {
  return state.coordinate(of<Panel>).value();
}
auto stops(const Sat& sat) {
  return stop_at(sat, of<Panel>, lower * rad, upper * rad, k * N_m / rad, c * (N_m / rad_s));
}
/// A constant torque from the start on, for 9 s.
auto push(const Sat& sat, double torque, double begin) {
  return pulse(sat, of<Panel>, Quantity<si::torque>(torque * N_m), begin * s, (begin + 9.0) * s);
}
/// p under a torque M into the stop, from p = p' = 0.
double pressed(double t) {
  const double turned = w * root * t;
  return M / k * (1.0 - std::exp(-z * w * t) * (std::cos(turned) + z / root * std::sin(turned)));
}

// On, and one digit inside, of either stop; the mass and the wheel are free. A torque into the stop is held.
TEST(StopRest, ALoadIntoTheStopIsHeld) {
  const Sat sat;
  for (const int side : {1, -1})
    for (const double begin : {0.0, 8e8})
      for (const bool inside : {false, true}) {
        const double angle = inside ? std::nextafter(limit_of(side), 0.0) : limit_of(side);
        const auto flight = propagate(scenario(sat, stops(sat), push(sat, side * M, begin)),
                                      start_of(sat, {.time = begin, .angle = angle}), until(begin + 1.0));
        EXPECT_EQ(flight.events().size(), inside ? 1U : 0U);
        EXPECT_EQ(flight.held<AtStop<Panel>>(begin * s).side, inside ? 0 : side);
        EXPECT_EQ(flight.held<AtStop<Panel>>((begin + 1.0) * s).side, side);
        // Of the time at which it meets the stop, and what it does meanwhile.
        const double late = inside && begin > 0.0 ? M / J * 0x1p-23 : 0.0;
        for (double t = 0.0; t <= 1.0; t += 0.0625)
          EXPECT_NEAR(side * (angle_of(flight.at((begin + t) * s)) - limit_of(side)), pressed(t),
                      rounding + late * t);
      }
}

// Away from the stop it is free, as without one; with no load it does not move at all.
TEST(StopRest, ItIsFreeTheOtherWay) {
  const Sat sat;
  for (const int side : {1, -1})
    for (const double begin : {0.0, 8e8}) {
      const auto start = start_of(sat, {.time = begin, .angle = limit_of(side)});
      const double torque = 0.3;
      const auto away =
          propagate(scenario(sat, stops(sat), push(sat, -side * torque, begin)), start, until(begin + 1.0));
      const auto alone = propagate(scenario(sat, stops(sat)), start, until(begin + 1.0));
      EXPECT_EQ(away.events().size(), 0U);
      EXPECT_EQ(alone.events().size(), 0U);
      for (double t = 0.0; t <= 1.0; t += 0.0625) {
        EXPECT_NEAR(angle_of(away.at((begin + t) * s)), limit_of(side) - side * 0.5 * torque / J * t * t,
                    rounding);
        EXPECT_EQ(angle_of(alone.at((begin + t) * s)), limit_of(side));
      }
    }
}

// No load at first, then one that grows as a t from there: p = a t/k - a c/k^2 + what dies out. Or one that
// begins later at once.
TEST(StopRest, ALoadThatGrowsFromNothingIsHeld) {
  const Sat sat;
  constexpr double a = 2.0;
  for (const int side : {1, -1})
    for (const double angle : {limit_of(side), std::nextafter(limit_of(side), 0.0)}) {
      const auto torque = [side](Quantity<si::time> t) { return side * a * t.value() * N_m; };
      const auto flight = propagate(scenario(sat, stops(sat), of_time(sat, of<Panel>, torque)),
                                    start_of(sat, {.angle = angle}), until(2.0));
      EXPECT_EQ(flight.events().size(), 1U);
      EXPECT_EQ(flight.held<AtStop<Panel>>(2.0 * s).side, side);
      const double A = a * c / (k * k), B = (z * w * A - a / k) / (w * root);
      for (double t = 0.0; t <= 2.0; t += 0.125) {
        const double p =
            a * t / k - A + std::exp(-z * w * t) * (A * std::cos(w * root * t) + B * std::sin(w * root * t));
        EXPECT_NEAR(side * (angle_of(flight.at(t * s)) - limit_of(side)), p, rounding) << t;
      }
      const auto later =
          propagate(scenario(sat, stops(sat), pulse(sat, of<Panel>, side * M * N_m, 1.0 * s, 9.0 * s)),
                    start_of(sat, {.angle = angle}), until(2.0));
      for (double t = 1.0; t <= 2.0; t += 0.125)
        EXPECT_NEAR(side * (angle_of(later.at(t * s)) - limit_of(side)), pressed(t - 1.0), rounding) << t;
    }
}

// With a speed into the stop, from exactly at it: the push ends as that of a bounce does, and then it coasts.
TEST(StopRest, ASpeedIntoTheStopBounces) {
  const Sat sat;
  constexpr double v = 1.0;
  const double contact = std::atan2(2.0 * z * root, 2.0 * z * z - 1.0) / (w * root);
  for (const int side : {1, -1}) {
    const auto flight = propagate(scenario(sat, stops(sat)),
                                  start_of(sat, {.angle = limit_of(side), .rate = side * v}), until(0.5));
    ASSERT_EQ(flight.events().size(), 1U);
    const auto last = flight.events()[0].state;
    EXPECT_NEAR(last.time().value(), contact, rounding);
    const double out = -v * std::exp(-z * w * contact);
    EXPECT_NEAR(side * last.speed(of<Panel>).value(), out, rounding);
    for (double t = 0.0; t <= 0.5; t += 0.0625) {
      const double pushed = v / (w * root) * std::exp(-z * w * t) * std::sin(w * root * t);
      const double coasting = -out * c / k + out * (t - contact);
      EXPECT_NEAR(side * (angle_of(flight.at(t * s)) - limit_of(side)), t < contact ? pushed : coasting,
                  rounding);
    }
  }
}

TEST(StopRest, OneDigitOutsideIsRefused) {
  const Sat sat;
  const auto complaint = [&](double angle) {
    return message<CraftFailure<Sat, AtStop<Panel>>>(
        [&] { propagate(scenario(sat, stops(sat)), start_of(sat, {.angle = angle}), until(1.0)); });
  };
  const std::string panel = frame_name<Panel>();
  EXPECT_TRUE(
      contains(complaint(std::nextafter(upper, infinite)),
               "stop_at: " + panel + " starts at 0.30000000000000004 rad, outside [-0.4 rad, 0.3 rad]"))
      << complaint(std::nextafter(upper, infinite));
  EXPECT_TRUE(
      contains(complaint(std::nextafter(lower, -infinite)),
               "stop_at: " + panel + " starts at -0.4000000000000001 rad, outside [-0.4 rad, 0.3 rad]"))
      << complaint(std::nextafter(lower, -infinite));
}

}  // namespace
}  // namespace vectrix_test::three_parts::stop_rest_test
