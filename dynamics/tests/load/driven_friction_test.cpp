#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/lockable.hpp>
#include <vectrix/dynamics/load/prescribed.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "load/sine.hpp"
#include "load/three_parts.hpp"

// Friction where the motion is given, or the joint is locked: it loads the drive or the latch alone.
namespace vectrix_test::three_parts::driven_friction_test {
namespace {

const Sat sat;
constexpr double tolerance = 1e-13;
/// A step changes each number by tolerance (1 + |y|) at most; numbers are below ten, steps below a hundred.
constexpr double run_error = 1e3 * tolerance;
constexpr double M_c = 0.3, M_s = 0.5, u_s = 0.2, c = 0.1;

/// What friction adds to the drive.
double drag(double u) {
  const double of_stribeck = u / u_s;
  return std::copysign(M_c + (M_s - M_c) * std::exp(-of_stribeck * of_stribeck), u) + c * u;
}
auto rub_panel() {
  return friction(sat, of<Panel>, M_c * N_m, M_s * N_m, u_s * rad_s, c * (N_m / rad_s));
}

constexpr double amplitude = 0.4, rate = 3.0, period = 2.0 * std::numbers::pi / rate;
/// u = 0 at the quarter period and each half period after it.
auto turning(double phase) {
  return vectrix_test::turning(Sine{amplitude, rate, 0.0, -phase / rate});
}
Starting start_at(double phase, double time = 0.0) {
  const auto given = turning(phase)(time * s);
  return {.time = time, .angle = given.coordinate.value(), .rate = given.speed.value(), .hub_rate = 0.2};
}

// The panel moves as without friction; the drive gives the friction too, on both sides of each reversal.
TEST(DrivenFriction, IsALoadOfTheDriveThroughReversals) {
  const auto drive = prescribed(sat, of<Panel>, turning(0.0));
  const auto alone = scenario(sat, drive);
  const auto free_run = propagate(alone, start_of(sat, start_at(0.0)), until(2.0 * period));
  const auto check = [&](const auto& rubbed) {
    const auto run = propagate(rubbed, start_of(sat, start_at(0.0)), until(2.0 * period));
    ASSERT_EQ(run.events().size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      const double reversal = (0.25 + 0.5 * static_cast<double>(k)) * period;
      EXPECT_EQ(run.events()[k].name, frame_name<Panel>() + " comes to rest");
      EXPECT_NEAR(run.events()[k].state.time().value(), reversal, run_error);
    }
    for (double t = 0.05; t < 2.0 * period; t += 0.1) {
      const auto with = motion_at(rubbed, run, t * s), without = motion_at(alone, free_run, t * s);
      const double u = turning(0.0)(t * s).speed.value();
      for (std::size_t i = 0; i < Sat::state_size; ++i)
        EXPECT_NEAR(with.state().data()[i], without.state().data()[i], run_error) << t << ' ' << i;
      EXPECT_NEAR((with.holding_effort(of<Panel>) - without.holding_effort(of<Panel>)).value(), drag(u),
                  10.0 * run_error)
          << t;
    }
  };
  check(scenario(sat, rub_panel(), drive));
  check(scenario(sat, drive, rub_panel()));
}

// At the start u = 0: the friction has the sign of the speed that follows.
TEST(DrivenFriction, StartsAtAReversal) {
  for (const double phase : {0.5 * std::numbers::pi, 1.5 * std::numbers::pi}) {
    auto start = start_at(phase);
    start.rate = 0.0;
    const auto flight = scenario(sat, rub_panel(), prescribed(sat, of<Panel>, turning(phase)));
    const auto run = propagate(flight, start_of(sat, start), until(0.25 * period));
    EXPECT_EQ(run.held<StickSlip<Panel>>(0.0 * s).slips, phase < std::numbers::pi ? -1 : 1);
    EXPECT_TRUE(run.events().empty());
  }
}

// A drive at rest is not loaded, nor one whose speed only touches zero.
TEST(DrivenFriction, AtRestItIsZero) {
  const auto still = [](const Quantity<si::time>&) {
    return JointMotion{0.3 * rad, 0.0 * rad_s, 0.0 * (rad_s / s)};
  };
  const auto standing = scenario(sat, rub_panel(), prescribed(sat, of<Panel>, still),
                                 pulse(sat, of<Hub>, 5.0 * N_m * unit_z(in<Hub>), 1.0 * s, 2.0 * s));
  const auto run = propagate(standing, start_of(sat, {.angle = 0.3}), until(3.0));
  EXPECT_TRUE(run.events().empty());
  EXPECT_EQ(run.at(3.0 * s).speed(of<Panel>).value(), 0.0);
  const double alpha = 5.0 / (J_rest + J_panel);
  EXPECT_NEAR(motion_at(standing, run, 1.5 * s).holding_effort(of<Panel>).value(), J_panel * alpha,
              run_error);

  const auto touching = [](const Quantity<si::time>& t) {
    const double x = t.value();
    return JointMotion{x * x * x * rad, 3.0 * x * x * rad_s, 6.0 * x * (rad_s / s)};
  };
  const auto rubbed = scenario(sat, rub_panel(), prescribed(sat, of<Panel>, touching));
  const auto starts_at_rest = propagate(rubbed, start_of(sat, {}), until(1.0));
  EXPECT_EQ(starts_at_rest.held<StickSlip<Panel>>(0.0 * s).slips, 0);
  EXPECT_EQ(starts_at_rest.held<StickSlip<Panel>>(0.5 * s).slips, 1);
  const auto through =
      propagate(rubbed, start_of(sat, {.time = -1.0, .angle = -1.0, .rate = 3.0}), until(1.0));
  EXPECT_EQ(through.held<StickSlip<Panel>>(-0.5 * s).slips, 1);
  EXPECT_EQ(through.held<StickSlip<Panel>>(0.5 * s).slips, 1);
  EXPECT_NEAR(through.at(1.0 * s).coordinate(of<Panel>).value(), 1.0, run_error);
}

TEST(DrivenFriction, OfARotorAndASlider) {
  const auto throttle = [](const Quantity<si::time>& t) {
    const double x = rate * t.value();
    return RotorMotion{5.0 * std::cos(x) * rad_s, -5.0 * rate * std::sin(x) * (rad_s / s)};
  };
  const auto to_and_fro = [](const Quantity<si::time>& t) { return Sine{0.1, rate}.sliding(t.value()); };
  const auto alone =
      scenario(sat, prescribed(sat, of<Wheel>, throttle), prescribed(sat, of<Mass>, to_and_fro));
  const auto rubbed =
      scenario(sat, friction(sat, of<Wheel>, M_c * N_m, M_s * N_m, u_s * rad_s, c * (N_m / rad_s)),
               friction(sat, of<Mass>, M_c * si::newton, M_s * si::newton, u_s * m_s, c * (si::newton / m_s)),
               prescribed(sat, of<Wheel>, throttle), prescribed(sat, of<Mass>, to_and_fro));
  const auto start = start_of(sat, {.velocity = 0.1 * rate, .spin = 5.0});
  const auto run = propagate(rubbed, start, until(period));
  const auto free_run = propagate(alone, start, until(period));
  EXPECT_EQ(run.events().size(), 4U);
  for (double t = 0.05; t < period; t += 0.1) {
    const auto with = motion_at(rubbed, run, t * s), without = motion_at(alone, free_run, t * s);
    for (std::size_t i = 0; i < Sat::state_size; ++i)
      EXPECT_NEAR(with.state().data()[i], without.state().data()[i], run_error) << t << ' ' << i;
    EXPECT_NEAR((with.holding_effort(of<Wheel>) - without.holding_effort(of<Wheel>)).value(),
                drag(throttle(t * s).speed.value()), 10.0 * run_error);
    EXPECT_NEAR((with.holding_effort(of<Mass>) - without.holding_effort(of<Mass>)).value(),
                drag(to_and_fro(t * s).speed.value()), 10.0 * run_error);
  }
}

// A latch keeps a joint at rest whatever its friction; released under a torque beyond M_s, it slips at once.
TEST(DrivenFriction, ALatchHoldsBeyondTheBreakawayEffort) {
  static constexpr double torque = 2.0;
  const auto flight = scenario(
      sat, rub_panel(), lockable(sat, of<Panel>, Locked<Panel>{true}),
      at_times({1.0 * s}, becomes(Locked<Panel>{false})), at_times({2.0 * s}, becomes(Locked<Panel>{true})),
      [](const Now<Sat>&, Forces<Sat>& forces) { forces.effort(of<Panel>, torque * N_m); });
  const auto run = propagate(flight, start_of(sat, {}), until(3.0));
  for (const double t : {0.0, 0.5, 2.0, 2.5, 3.0})
    EXPECT_EQ(run.at(t * s).speed(of<Panel>).value(), 0.0) << t;
  EXPECT_EQ(run.held<StickSlip<Panel>>(0.5 * s).slips, 0);
  EXPECT_EQ(run.held<StickSlip<Panel>>(1.5 * s).slips, 1);
  EXPECT_EQ(run.held<StickSlip<Panel>>(2.5 * s).slips, 0);
  EXPECT_GT(run.at(1.9 * s).speed(of<Panel>).value(), 0.5);
}

}  // namespace
}  // namespace vectrix_test::three_parts::driven_friction_test
