#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/dynamics/load/stop_at.hpp>

#include "load/three_parts.hpp"

// The stops of a slider and a hinge, against the closed forms of a bounce.
namespace vectrix_test::three_parts::stop_at_test {
namespace {

constexpr double rounding = 1e-12;  // of numbers near 1, in some hundred steps
const auto N_per_m = N / m;
const auto N_s_per_m = N / m_s;
constexpr double reduced = 1.0 / (1.0 / m_mass + 1.0 / (m_hub + m_panel));

double speed_of(const CraftState<Sat>& state) {
  return state.speed(of<Mass>).value();
}
double length_of(const CraftState<Sat>& state) {
  return state.coordinate(of<Mass>).value();
}

// Without damping: half a period on a stop, and back with the same speed, from one stop to the other.
TEST(StopAt, ItBouncesBetweenItsStops) {
  const Sat sat;
  constexpr double k = 200.0, v = 0.5;
  const auto flight =
      propagate(scenario(sat, stop_at(sat, of<Mass>, -0.2 * m, 0.3 * m, k * N_per_m, 0.0 * N_s_per_m)),
                start_of(sat, {.velocity = v}), until(5.0));
  const double contact = std::numbers::pi * std::sqrt(reduced / k);
  const auto events = flight.events();
  ASSERT_GE(events.size(), 4U);
  const double times[] = {0.3 / v, 0.3 / v + contact, 0.8 / v + contact, 0.8 / v + 2.0 * contact};
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(events[i].state.time().value(), times[i], 10 * rounding) << events[i].name;
  EXPECT_EQ(events[0].name, frame_name<Mass>() + " meets its upper stop");
  EXPECT_EQ(events[1].name, frame_name<Mass>() + " leaves its stop");
  EXPECT_EQ(events[2].name, frame_name<Mass>() + " meets its lower stop");
  EXPECT_NEAR(speed_of(events[1].state), -v, 10 * rounding);
  EXPECT_NEAR(length_of(events[3].state), -0.2, 10 * rounding);
  EXPECT_NEAR(length_of(flight.at((times[0] + 0.5 * contact) * s)), 0.3 + v * std::sqrt(reduced / k),
              10 * rounding);
  EXPECT_EQ(flight.held<AtStop<Mass>>((times[0] + 0.5 * contact) * s).side, 1);
  EXPECT_EQ(flight.held<AtStop<Mass>>(0.1 * s).side, 0);
}

// With the damping ratio z the push ends at w_d t = atan2(2 z (1 - z^2)^(1/2), 2 z^2 - 1), with the speed
// -v exp(-z w t), still v exp(-z w t) c/k beyond the stop.
TEST(StopAt, DampingTakesSpeedAndNeverPulls) {
  const Sat sat;
  constexpr double k = 200.0, v = 0.5;
  for (const double z : {0.01, 0.3, 0.9}) {
    const double w = std::sqrt(k / reduced), c = 2.0 * z * reduced * w;
    const auto flight =
        propagate(scenario(sat, stop_at(sat, of<Mass>, -9.0 * m, 0.3 * m, k * N_per_m, c * N_s_per_m)),
                  start_of(sat, {.velocity = v}), until(5.0));
    ASSERT_EQ(flight.events().size(), 2U);
    const double root = std::sqrt(1.0 - z * z),
                 contact = std::atan2(2.0 * z * root, 2.0 * z * z - 1.0) / (w * root);
    const auto last = flight.events()[1].state;
    EXPECT_NEAR(last.time().value(), 0.3 / v + contact, 10 * rounding);
    EXPECT_NEAR(speed_of(last), -v * std::exp(-z * w * contact), 10 * rounding);
    EXPECT_NEAR(length_of(last), 0.3 - speed_of(last) * c / k, 10 * rounding);
    EXPECT_NEAR(speed_of(flight.at(5.0 * s)), speed_of(last), 10 * rounding);
  }
}

// A force drives it back while it is still beyond the stop, which pushes again; at last the spring holds the
// force. With x = p - F/k beyond the stop x'' + 2 z w x' + w^2 x = 0, else p'' = F/m.
TEST(StopAt, ItHoldsWhatPushesAgainstIt) {
  const Sat sat;
  constexpr double k = 50.0, c = 8.0;
  struct Case {
    double F;
    std::size_t events;
  };
  for (const auto& [F, count] : {Case{2.0, 1}, Case{0.5, 3}}) {
    const auto effort = Quantity<si::force>(F * N);
    const auto flight =
        propagate(scenario(sat, stop_at(sat, of<Mass>, -1.0 * m, 0.0 * m, k * N_per_m, c * N_s_per_m),
                           pulse(sat, of<Mass>, effort, 0.0 * s, 100.0 * s)),
                  start_of(sat, {.length = -0.5}), until(40.0));
    const double w = std::sqrt(k / reduced), z = c / (2.0 * reduced * w), root = std::sqrt(1.0 - z * z);
    const auto events = flight.events();
    ASSERT_EQ(events.size(), count);
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(events[i].name, frame_name<Mass>() + (i == 1 ? " leaves its stop" : " meets its upper stop"));
    EXPECT_NEAR(events[0].state.time().value(), std::sqrt(2.0 * 0.5 * reduced / F), 10 * rounding);
    for (std::size_t i = 1; i < count; ++i)
      EXPECT_NEAR(k * length_of(events[i].state) + c * speed_of(events[i].state), 0.0, 10 * k * rounding);
    for (std::size_t i = 0; i < count; ++i) {
      const double begin = events[i].state.time().value();
      const double end = i + 1 < count ? events[i + 1].state.time().value() : 40.0;
      const double p = length_of(events[i].state), v = speed_of(events[i].state);
      for (double part = 0.1; part <= 1.0; part += 0.1) {
        const double t = part * (end - begin), x = p - F / k, turned = w * root * t;
        const double pushed =
            F / k + std::exp(-z * w * t) * (x * std::cos(turned) + (v / w + z * x) / root * std::sin(turned));
        const double free = p + v * t + 0.5 * F / reduced * t * t;
        EXPECT_NEAR(length_of(flight.at((begin + t) * s)), i == 1 ? free : pushed, 10 * rounding) << i;
      }
    }
    EXPECT_NEAR(length_of(flight.at(40.0 * s)), F / k, 10 * rounding);
    EXPECT_EQ(flight.template held<AtStop<Mass>>(40.0 * s).side, 1);
  }
}

TEST(StopAt, RefusesBadInput) {
  const Sat sat;
  const auto complaint = [&](double lower, double upper, double k, double c) {
    return message<BadInput>(
        [&] { stop_at(sat, of<Mass>, lower * m, upper * m, k * N_per_m, c * N_s_per_m); });
  };
  const std::string on_mass = "stop_at on " + frame_name<Mass>();
  EXPECT_EQ(complaint(1.0, 1.0, 1.0, 0.0), on_mass + ": the lower limit is 1 m, the upper 1 m");
  EXPECT_EQ(complaint(1.0, std::nextafter(1.0, 0.0), 1.0, 0.0),
            on_mass + ": the lower limit is 1 m, the upper 0.9999999999999999 m");
  EXPECT_EQ(complaint(0.0, std::nan(""), 1.0, 0.0), on_mass + ": the upper limit is nan m");
  EXPECT_EQ(complaint(0.0, 1.0, 0.0, 0.0), on_mass + ": the stiffness is 0 SI units; it must be positive");
  EXPECT_EQ(complaint(0.0, 1.0, 1.0, -1.0),
            on_mass + ": the damping is -1 SI units; it must not be negative");
  const auto stopped =
      scenario(sat, stop_at(sat, of<Mass>, 0.0 * m, 1.0 * m, 1.0 * N_per_m, 0.0 * N_s_per_m));
  try {
    propagate(stopped, start_of(sat, {.length = 1.5}), until(1.0));
    FAIL() << "no failure";
  } catch (const CraftFailure<Sat, AtStop<Mass>>& failure) {
    const std::string wanted = "stop_at: " + frame_name<Mass>() + " starts at 1.5 m, outside [0 m, 1 m]";
    EXPECT_TRUE(contains(failure.what(), wanted)) << failure.what();
  }
}

}  // namespace
}  // namespace vectrix_test::three_parts::stop_at_test
