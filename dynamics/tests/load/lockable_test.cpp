#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/lockable.hpp>
#include <vectrix/dynamics/load/springs.hpp>
#include <vectrix/dynamics/load/stop_at.hpp>

#include "load/three_parts.hpp"

// Joints and rotors that are locked while they move, against the closed forms of inelastic impacts.
namespace vectrix_test::three_parts::lockable_test {
namespace {

constexpr double rounding = 1e-12;  // of numbers near 1, in some hundred steps
const auto rising = ode::Direction::rising;

double hub_rate(const CraftState<Sat>& state) {
  return state.turning().angular_velocity.coordinates().z();
}
double hub_velocity(const CraftState<Sat>& state) {
  return state.hub_motion().velocity.coordinates().x();
}
double rate(const CraftState<Sat>& state) {
  return state.speed(of<Panel>).value();
}
double angle(const CraftState<Sat>& state) {
  return state.coordinate(of<Panel>).value();
}
template <class On> auto lock_at(double time) {
  return at_times({time * s}, becomes(Locked<On>{true}));
}
auto reaches(double wanted) {
  return when(
      "deployed", [=](const Now<Sat>& now) { return now.coordinate(of<Panel>) - wanted * rad; }, rising,
      becomes(Locked<Panel>{true}));
}

// The panel turns by u relative to the hub, and latches: both turn as one, with the angular momentum that
// they had. The wheel is free: it goes on turning as it did in the inertial frame. No energy is lost but that
// of u.
void expect_inelastic_impact(AttitudeState attitude) {
  const Sat sat;
  constexpr double u = 0.4, w = 0.1, O = 3.0, at = 0.3;
  CraftPropagation how = until(2.0);
  how.attitude = attitude;
  const auto flight = propagate(scenario(sat, lockable(sat, of<Panel>), reaches(at)),
                                start_of(sat, {.rate = u, .spin = O, .hub_rate = w}), how);
  ASSERT_EQ(flight.events().size(), 1U);
  const CraftState<Sat> before = flight.events().front().state;
  const auto time = before.time();
  EXPECT_NEAR(time.value(), at / u, rounding);
  EXPECT_NEAR(rate(before), u, rounding);
  EXPECT_FALSE(flight.held<Locked<Panel>>(0.5 * time).locked);
  EXPECT_TRUE(flight.held<Locked<Panel>>(time).locked);
  constexpr double together = w + J_panel * u / (J_rest + J_panel);
  for (const auto& after : {flight.at(time), flight.at(2.0 * s)}) {
    EXPECT_NEAR(hub_rate(after), together, rounding);
    EXPECT_EQ(rate(after), 0.0);
    EXPECT_EQ(angle(after), angle(before));
    EXPECT_NEAR(after.spin(of<Wheel>).value(), O - (together - w), rounding);
  }
  const auto energy = [&](const CraftState<Sat>& state) { return motion(sat, state).energy().value(); };
  EXPECT_NEAR(energy(before) - energy(flight.at(time)), 0.5 * u * u / (1.0 / J_rest + 1.0 / J_panel),
              rounding);
}
TEST(Lockable, AHingeThatIsLatchedIsAnInelasticImpact) {
  expect_inelastic_impact(AttitudeState::quaternion);
  expect_inelastic_impact(AttitudeState::dcm);
}

TEST(Lockable, ASlider) {
  const Sat sat;
  constexpr double v = 0.4;
  const auto flight = propagate(scenario(sat, lockable(sat, of<Mass>), lock_at<Mass>(1.0)),
                                start_of(sat, {.velocity = v}), until(2.0));
  EXPECT_NEAR(hub_velocity(flight.at(2.0 * s)), v * m_mass / (m_hub + m_panel + m_mass), rounding);
  EXPECT_EQ(flight.at(2.0 * s).speed(of<Mass>).value(), 0.0);
}

// A brake gives the wheel's momentum to the hub; the panel on its free hinge goes on as it did.
TEST(Lockable, AWheel) {
  const Sat sat;
  constexpr double O = 30.0, u = 0.2;
  const auto flight = propagate(scenario(sat, lockable(sat, of<Wheel>), lock_at<Wheel>(1.0)),
                                start_of(sat, {.rate = u, .spin = O}), until(2.0));
  constexpr double braked = J_wheel * O / (J_rest + J_wheel);
  EXPECT_NEAR(hub_rate(flight.at(2.0 * s)), braked, rounding);
  EXPECT_EQ(flight.at(2.0 * s).spin(of<Wheel>).value(), 0.0);
  EXPECT_NEAR(rate(flight.at(2.0 * s)), u - braked, rounding);
}

// What is locked at one instant is stopped by one impact; what is locked already stays so in a later one.
TEST(Lockable, SeveralAtOnceAndInTurn) {
  const Sat sat;
  constexpr double O = 30.0, u = 0.2;
  const auto start = start_of(sat, {.rate = u, .spin = O});
  const auto panel = lockable(sat, of<Panel>);
  const auto wheel = lockable(sat, of<Wheel>);
  constexpr double whole = (J_panel * u + J_wheel * O) / (J_rest + J_panel + J_wheel);
  for (const double later : {1.0, 1.5}) {
    const auto flight =
        propagate(scenario(sat, panel, wheel, lock_at<Panel>(1.0), lock_at<Wheel>(later)), start, until(2.0));
    EXPECT_NEAR(hub_rate(flight.at(2.0 * s)), whole, rounding);
    EXPECT_EQ(rate(flight.at(2.0 * s)), 0.0);
    EXPECT_NEAR(angle(flight.at(2.0 * s)), u, rounding);
  }
}

// Stowed against a spring until it is released, and latched when it passes through zero.
TEST(Lockable, ReleasedAndLatched) {
  const Sat sat;
  constexpr double stowed = -0.5, k = 2.0;
  const auto flight = propagate(scenario(sat, lockable(sat, of<Panel>, Locked<Panel>{true}),
                                         spring(sat, of<Panel>, k * N_m / rad, 0.0 * rad),
                                         at_times({1.0 * s}, becomes(Locked<Panel>{false})), reaches(0.0)),
                                start_of(sat, {.angle = stowed}), until(4.0));
  EXPECT_EQ(angle(flight.at(1.0 * s)), stowed);
  const double frequency = std::sqrt(k * (1.0 / J_rest + 1.0 / J_panel));
  ASSERT_EQ(flight.events().size(), 1U);
  EXPECT_NEAR(flight.events().front().state.time().value(), 1.0 + 0.5 * std::numbers::pi / frequency,
              rounding);
  EXPECT_NEAR(rate(flight.events().front().state), -stowed * frequency, rounding);
  EXPECT_NEAR(hub_rate(flight.at(4.0 * s)), 0.0, rounding);
  EXPECT_NEAR(angle(flight.at(4.0 * s)), 0.0, rounding);
}

// Friction is finite: a panel that sticks slips after the impact, and what it had in the inertial frame it
// has.
TEST(Lockable, WhatSticksSlips) {
  const Sat sat;
  constexpr double O = 30.0, M = 0.05;
  const auto rub = friction(sat, of<Panel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * (N_m / rad_s));
  const auto flight = propagate(scenario(sat, lockable(sat, of<Wheel>), lock_at<Wheel>(1.0), rub),
                                start_of(sat, {.spin = O}), until(1.25));
  constexpr double braked = J_wheel * O / (J_rest + J_wheel);
  EXPECT_EQ(flight.held<StickSlip<Panel>>(0.5 * s).slips, 0);
  EXPECT_EQ(flight.held<StickSlip<Panel>>(1.0 * s).slips, -1);
  EXPECT_NEAR(rate(flight.at(1.0 * s)), -braked, rounding);
  constexpr double slows = M * (1.0 / (J_rest + J_wheel) + 1.0 / J_panel);
  EXPECT_NEAR(rate(flight.at(1.25 * s)), -braked + 0.25 * slows, rounding);
}
// It also goes on the other way at once, where the impact turns its speed round; locked itself, it sticks.
TEST(Lockable, WhatSlipsSlipsBackOrSticks) {
  const Sat sat;
  constexpr double O = 30.0, u = 0.2;
  const auto rub = friction(sat, of<Panel>, 0.01 * N_m, 0.01 * N_m, 1.0 * rad_s, 0.0 * (N_m / rad_s));
  const auto start = start_of(sat, {.rate = u, .spin = O});
  const auto back =
      propagate(scenario(sat, rub, lockable(sat, of<Wheel>), lock_at<Wheel>(1.0)), start, until(1.25));
  EXPECT_EQ(back.held<StickSlip<Panel>>(0.5 * s).slips, 1);
  EXPECT_EQ(back.held<StickSlip<Panel>>(1.0 * s).slips, -1);
  const auto H = [&](double t) { return motion(sat, back.at(t * s)).angular_momentum().coordinates().z(); };
  EXPECT_NEAR(H(1.25), H(0.0), rounding);
  const auto sticks =
      propagate(scenario(sat, rub, lockable(sat, of<Panel>), lock_at<Panel>(1.0)), start, until(1.25));
  EXPECT_EQ(sticks.held<StickSlip<Panel>>(1.0 * s).slips, 0);
  EXPECT_EQ(rate(sticks.at(1.25 * s)), 0.0);
}

// An impact throws the panel off its stop, which does not pull; another drives it back in while it leaves.
TEST(Lockable, AStopNeitherPullsNorMisses) {
  const Sat sat;
  constexpr double k = 100.0, c = 5.0, upper = 0.3, u = 0.2;
  const auto stops = stop_at(sat, of<Panel>, -0.4 * rad, upper * rad, k * N_m / rad, c * (N_m / rad_s));
  const auto flown = [&](double O, double at) {
    return propagate(scenario(sat, stops, lockable(sat, of<Wheel>), lock_at<Wheel>(at)),
                     start_of(sat, {.rate = u, .spin = O}), until(at + 0.01));
  };
  const auto side = [](const auto& flight, double t) {
    return flight.template held<AtStop<Panel>>(t * s).side;
  };
  const double presses = upper / u + 0.02;
  const auto off = flown(30.0, presses);
  EXPECT_EQ(side(off, presses - 1e-3), 1);
  EXPECT_EQ(side(off, presses), 0);
  EXPECT_LT(rate(off.at(presses * s)), 0.0);
  EXPECT_NEAR(rate(off.at((presses + 0.01) * s)), rate(off.at(presses * s)), rounding);

  const auto alone = propagate(scenario(sat, stops), start_of(sat, {.rate = u}), until(2.0));
  const double leaves = alone.events().back().state.time().value() + 1e-4;
  EXPECT_GT(angle(alone.at(leaves * s)), upper);
  const auto back = flown(-30.0, leaves);
  EXPECT_EQ(side(back, leaves - 1e-5), 0);
  EXPECT_EQ(side(back, leaves), 1);
  EXPECT_LT(rate(back.at((leaves + 0.01) * s)), rate(back.at(leaves * s)));
}

// forces.lock() is rigid, and whatever it locks goes on at its speed.
TEST(Lockable, WhatALoadLocksIsRigid) {
  const Sat sat;
  constexpr double O = 30.0;
  const auto rigid = [](const Now<Sat>&, Forces<Sat>& forces) { forces.lock(of<Panel>); };
  const auto flight = propagate(scenario(sat, rigid, lockable(sat, of<Wheel>), lock_at<Wheel>(1.0)),
                                start_of(sat, {.rate = 0.2, .spin = O}), until(2.0));
  EXPECT_NEAR(hub_rate(flight.at(2.0 * s)), J_wheel * O / (J_rest + J_wheel + J_panel), rounding);
  EXPECT_EQ(rate(flight.at(2.0 * s)), 0.2);
}

TEST(Lockable, AStartThatIsLockedAndMovesFails) {
  const Sat sat;
  const auto from = [&](double rate) {
    return propagate(scenario(sat, lockable(sat, of<Panel>, Locked<Panel>{true})),
                     start_of(sat, {.rate = rate}), until(1.0));
  };
  EXPECT_EQ(angle(from(0.0).at(1.0 * s)), 0.0);
  try {
    from(0.25);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("Panel is locked and moves at the start, 0.25 rad/s"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace vectrix_test::three_parts::lockable_test
