#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/dynamics/load/springs.hpp>
#include <vectrix/dynamics/load/stop_at.hpp>

#include "load/three_parts.hpp"
#include "methods.hpp"

// Friction and stops with every method of integration, against closed forms.
namespace vectrix_test::three_parts::steppers_test {
namespace {

constexpr double tolerance = 1e-11;
/// Of a whole run of some hundred steps, each with an error below the tolerance.
constexpr double reached = 1e3 * tolerance;
/// The rate of the wheel's speed for a torque of 1 N m between it and the hub; the panel turns freely.
constexpr double per_torque = 1.0 / J_wheel + 1.0 / J_rest;
CraftPropagation with(ode::Method method, double end) {
  auto how = until(end, tolerance);
  how.method = method;
  return how;
}

// O' = -k M_c: the wheel stops at O/(k M_c) and stays, though a motor pulls with as much; with twice as much
// it runs back, O' = -k M_c, and stops as soon after that.
TEST(Steppers, FrictionStopsAWheel) {
  const Sat sat;
  constexpr double M = 0.02, spin = 3.0, stops = spin / (per_torque * M);
  static_assert(stops > 14.0 && stops < 16.0);
  for (const ode::Method method : methods) {
    SCOPED_TRACE(name_of(method));
    const auto flight =
        propagate(scenario(sat, friction(sat, of<Wheel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * (N_m / rad_s)),
                           pulse(sat, of<Wheel>, -M * N_m, 20.0 * s, 25.0 * s),
                           pulse(sat, of<Wheel>, -2.0 * M * N_m, 30.0 * s, 35.0 * s)),
                  start_of(sat, {.spin = spin}), with(method, 50.0));
    const auto spin_at = [&](double t) { return flight.at(t * s).spin(of<Wheel>).value(); };
    const auto events = flight.events();
    ASSERT_EQ(events.size(), 2U);
    for (const auto& event : events) EXPECT_EQ(event.name, frame_name<Wheel>() + " comes to rest");
    EXPECT_NEAR(events[0].state.time().value(), stops, reached);
    EXPECT_NEAR(events[1].state.time().value(), 40.0, reached);
    EXPECT_NEAR(spin_at(10.0), spin - per_torque * M * 10.0, reached);
    for (const double t : {16.0, 22.0, 27.0, 30.0, 45.0, 50.0}) {
      EXPECT_NEAR(spin_at(t), 0.0, reached) << t;
      EXPECT_EQ(spin_at(t), spin_at(t < 31.0 ? 16.0 : 45.0)) << t;
      EXPECT_EQ(flight.held<StickSlip<Wheel>>(t * s).slips, t == 30.0 ? -1 : 0) << t;
    }
    EXPECT_NEAR(spin_at(35.0), -per_torque * M * 5.0, reached);
  }
}

// A motor's torque a t breaks it away at M/a; then O' = k (a t - M).
TEST(Steppers, AGrowingTorqueBreaksAWheelAway) {
  const Sat sat;
  constexpr double M = 0.05, a = 0.01;
  for (const ode::Method method : methods) {
    SCOPED_TRACE(name_of(method));
    const auto flight =
        propagate(scenario(sat, friction(sat, of<Wheel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * (N_m / rad_s)),
                           of_time(sat, of<Wheel>, [](Quantity<si::time> t) { return a * t.value() * N_m; })),
                  start_of(sat, {}), with(method, 10.0));
    ASSERT_EQ(flight.events().size(), 1U);
    EXPECT_NEAR(flight.events()[0].state.time().value(), M / a, reached);
    EXPECT_EQ(flight.at(4.9 * s).spin(of<Wheel>).value(), 0.0);
    EXPECT_NEAR(flight.at(10.0 * s).spin(of<Wheel>).value(), 0.5 * per_torque * a * 25.0, reached);
  }
}

// Half a period on an undamped stop, and back with the same speed.
TEST(Steppers, AStopThrowsBack) {
  const Sat sat;
  constexpr double k = 200.0, v = 0.5, reduced = 1.0 / (1.0 / m_mass + 1.0 / (m_hub + m_panel));
  const double contact = std::numbers::pi * std::sqrt(reduced / k);
  for (const ode::Method method : methods) {
    SCOPED_TRACE(name_of(method));
    const auto flight =
        propagate(scenario(sat, stop_at(sat, of<Mass>, -9.0 * m, 0.3 * m, k * (N / m), 0.0 * (N / m_s))),
                  start_of(sat, {.velocity = v}), with(method, 2.0));
    const auto events = flight.events();
    ASSERT_EQ(events.size(), 2U);
    EXPECT_NEAR(events[0].state.time().value(), 0.3 / v, reached);
    EXPECT_NEAR(events[1].state.time().value(), 0.3 / v + contact, reached);
    EXPECT_NEAR(flight.at((0.3 / v + 0.5 * contact) * s).coordinate(of<Mass>).value(),
                0.3 + v * std::sqrt(reduced / k), reached);
    EXPECT_NEAR(flight.at(2.0 * s).coordinate(of<Mass>).value(), 0.3 - v * (2.0 - 0.3 / v - contact),
                reached);
  }
}

// From rest exactly at a stop, pushed to it: p = M/k (1 - cos w t), w^2 = k/J.
TEST(Steppers, AStopHoldsFromTheStart) {
  const Sat sat;
  constexpr double k = 100.0, M = 3.0, J = 1.0 / (1.0 / J_panel + 1.0 / J_rest);
  for (const ode::Method method : methods) {
    SCOPED_TRACE(name_of(method));
    const auto flight = propagate(
        scenario(sat, stop_at(sat, of<Panel>, -0.4 * rad, 0.3 * rad, k * N_m / rad, 0.0 * (N_m / rad_s)),
                 pulse(sat, of<Panel>, M * N_m, 0.0 * s, 9.0 * s)),
        start_of(sat, {.angle = 0.3}), with(method, 0.35));
    for (double t = 0.0; t <= 0.35; t += 0.05)
      EXPECT_NEAR(flight.at(t * s).coordinate(of<Panel>).value(),
                  0.3 + M / k * (1.0 - std::cos(std::sqrt(k / J) * t)), reached);
  }
}

// A hinge that is nearly rigid: an explicit method takes steps of some J/c, says which joint wants them, and
// names the method that holds it.
TEST(Steppers, AStiffHingeIsNamed) {
  const Sat sat;
  const auto k = 1e6 * N_m / rad;
  const auto c = 1e6 * N_m / rad_s;
  const auto stiff = scenario(sat, spring(sat, of<Panel>, k, 0.0 * rad), damper(sat, of<Panel>, c));
  const auto start = start_of(sat, {.angle = 1e-3, .rate = -1e-3});
  auto how = with(ode::Method::verner_9, 10.0);
  how.max_steps = 1000;
  const auto said = message<CraftFailure<Sat>>([&] { (void)propagate(stiff, start, how); });
  EXPECT_TRUE(contains(said, "max_steps = 1000 reached: the error of ")) << said;
  EXPECT_TRUE(contains(said, frame_name<Panel>())) << said;
  EXPECT_TRUE(contains(said, "a stiff problem needs radau_iia_7")) << said;
  how.method = ode::Method::radau_iia_7;
  // What is left of the fast part is no longer there: q' = -k/c q.
  EXPECT_NEAR(propagate(stiff, start, how).at(10.0 * s).coordinate(of<Panel>).value(), 1e-3 * std::exp(-10.0),
              reached);
}

}  // namespace
}  // namespace vectrix_test::three_parts::steppers_test
