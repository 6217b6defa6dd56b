#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "load/three_parts.hpp"

// Friction that sticks, against closed forms.
namespace vectrix_test::three_parts::friction_test {
namespace {

constexpr double rounding = 1e-12;  // of numbers near 1, in some hundred steps

const auto N_m_s = N_m / rad_s;

auto make_wheeled() {
  return spacecraft(body(mass<Hub>(m_hub, J_hub), turning_in<Inertial>),
                    rotor(of<Wheel>, unit_z(in<Hub>), J_wheel * kg_m2));
}
struct Wheeled : decltype(make_wheeled()) {
  Wheeled() : decltype(make_wheeled())(make_wheeled()) {}
};
CraftState<Wheeled> spinning(const Wheeled& craft, double hub_rate, double spin) {
  return state(
      craft, 0.0 * s,
      moving_dcm(aligned(to<Inertial>, from<Hub>),
                 angular_velocity(of<Hub>, relative_to<Inertial>, hub_rate * rad_s * unit_z(in<Hub>))),
      spins(of<Wheel>, spin * rad_s));
}
/// The rate of the wheel's speed for a torque of 1 N m between hub and wheel.
constexpr double per_torque = 1.0 / J_wheel + 1.0 / (J_hub - J_wheel);

double spin_of(const auto& state) {
  return state.spin(of<Wheel>).value();
}
double rate_of(const auto& state) {
  return state.turning().angular_velocity.z().value();
}

// O' = -k M_c: it stops at O/(k M_c) and stays, while the hub is pushed; all turns as one body then.
TEST(Friction, AWheelRunsDownStopsAndStays) {
  const Wheeled craft;
  constexpr double M = 0.02, spin = -30.0, stops = 30.0 / (per_torque * M);
  static_assert(stops > 100.0 && stops < 150.0);
  const auto braked = scenario(craft, friction(craft, of<Wheel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * N_m_s),
                               pulse(craft, of<Hub>, 0.1 * N_m * unit_z(in<Hub>), 200.0 * s, 210.0 * s));
  const auto flight = propagate(braked, spinning(craft, 0.3, spin), until(300.0));
  ASSERT_EQ(flight.events().size(), 1U);
  EXPECT_NEAR(flight.events()[0].state.time().value(), stops, rounding * stops);
  EXPECT_EQ(flight.events()[0].name, frame_name<Wheel>() + " comes to rest");
  EXPECT_EQ(flight.held<StickSlip<Wheel>>(50.0 * s).slips, -1);
  EXPECT_EQ(flight.held<StickSlip<Wheel>>(150.0 * s).slips, 0);
  for (const double t : {1.0, 50.0, 100.0})
    EXPECT_NEAR(spin_of(flight.at(t * s)), spin + per_torque * M * t, 30.0 * rounding);
  const double together = 0.3 + J_wheel * spin / J_hub;
  for (const double t : {150.0, 199.0, 205.0, 250.0, 300.0}) {
    EXPECT_NEAR(spin_of(flight.at(t * s)), 0.0, 30.0 * rounding);
    EXPECT_EQ(spin_of(flight.at(t * s)), spin_of(flight.at(150.0 * s)));
    EXPECT_NEAR(rate_of(flight.at(t * s)), together + 0.1 / J_hub * std::min(std::max(t - 200.0, 0.0), 10.0),
                30.0 * rounding);
  }
}

// With viscous friction: O' = -k (M_c + c O), at rest at ln(1 + c O/M_c)/(k c).
TEST(Friction, ViscousFrictionStopsItSooner) {
  const Wheeled craft;
  constexpr double M = 0.02, c = 1e-3, spin = 40.0;
  const auto flight =
      propagate(scenario(craft, friction(craft, of<Wheel>, M * N_m, 2.0 * M * N_m, 1e-9 * rad_s, c * N_m_s)),
                spinning(craft, 0.0, spin), until(150.0));
  ASSERT_EQ(flight.events().size(), 1U);
  const double stops = std::log1p(c * spin / M) / (per_torque * c);
  EXPECT_NEAR(flight.events()[0].state.time().value(), stops, rounding * stops);
}

// The time from u to rest is the integral of du/(k M(u)), here by Simpson's rule.
TEST(Friction, StribeckFrictionGrowsTowardsRest) {
  const Wheeled craft;
  constexpr double M_c = 0.02, M_s = 0.05, u_s = 3.0, c = 1e-3, spin = 10.0;
  const auto flight =
      propagate(scenario(craft, friction(craft, of<Wheel>, M_c * N_m, M_s * N_m, u_s * rad_s, c * N_m_s)),
                spinning(craft, 0.0, spin), until(100.0));
  const auto slowness = [&](double u) {
    return 1.0 / (per_torque * (M_c + (M_s - M_c) * std::exp(-u * u / (u_s * u_s)) + c * u));
  };
  constexpr int intervals = 4000;
  const double h = spin / intervals;
  double stops = 0.0;
  for (int i = 0; i < intervals; ++i)
    stops += h / 6.0 * (slowness(i * h) + 4.0 * slowness((i + 0.5) * h) + slowness((i + 1) * h));
  ASSERT_EQ(flight.events().size(), 1U);
  EXPECT_NEAR(flight.events()[0].state.time().value(), stops, 10 * rounding * stops);
}

// The motor's torque grows as a t: it breaks away at M_s/a, and then, if M_c = M_s, O' = k (a t - M_c). Else
// M_s - M_c falls away within less than it would if O were only what it is with M_s, k a t^2/2, as t counts
// from there: the integral of exp(-(k a t^2/(2 u_s))^2).
TEST(Friction, AGrowingTorqueBreaksItAway) {
  const Wheeled craft;
  constexpr double M_s = 0.05, a = 0.01, u_s = 1e-6;
  struct Case {
    double sign, M_c;
  };
  for (const Case& one : {Case{1.0, M_s}, Case{-1.0, M_s}, Case{-1.0, 0.02}}) {
    const double sign = one.sign, M_c = one.M_c;
    const auto driven = scenario(
        craft, of_time(craft, of<Wheel>, [sign](Quantity<si::time> t) { return sign * a * t.value() * N_m; }),
        friction(craft, of<Wheel>, M_c * N_m, M_s * N_m, u_s * rad_s, 0.0 * N_m_s));
    const auto flight = propagate(driven, spinning(craft, 0.0, 0.0), until(10.0, 1e-12));
    ASSERT_EQ(flight.events().size(), 1U);
    EXPECT_EQ(flight.events()[0].name, frame_name<Wheel>() + " breaks away");
    EXPECT_NEAR(flight.events()[0].state.time().value(), M_s / a, rounding * 10.0);
    EXPECT_EQ(spin_of(flight.at(4.9 * s)), 0.0);
    EXPECT_EQ(flight.held<StickSlip<Wheel>>(5.1 * s).slips, sign);
    const double alone = per_torque * a * 25.0 / 2.0, found = sign * spin_of(flight.at(10.0 * s));
    const double gained = per_torque * (M_s - M_c);  // for each second after that
    const double fall = std::sqrt(2.0 * u_s / (per_torque * a)) * std::tgamma(1.25);
    EXPECT_LE(found, alone + gained * 5.0 + 10 * rounding);
    EXPECT_GE(found, alone + gained * (5.0 - fall) - 10 * rounding);
  }
}

// A motor's torque that jumps to more than M_s moves the wheel at once, one below M_s does not; nor does one
// at rest from the start.
TEST(Friction, AJumpBreaksItAwayAtOnce) {
  const Wheeled craft;
  constexpr double M = 0.05;
  const auto driven = scenario(craft, pulse(craft, of<Wheel>, 0.049 * N_m, 1.0 * s, 2.0 * s),
                               pulse(craft, of<Wheel>, -0.07 * N_m, 3.0 * s, 4.0 * s),
                               friction(craft, of<Wheel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * N_m_s));
  const auto flight = propagate(driven, spinning(craft, 0.1, 0.0), until(8.0));
  EXPECT_EQ(spin_of(flight.at(3.0 * s)), 0.0);
  EXPECT_EQ(flight.held<StickSlip<Wheel>>(3.0 * s).slips, -1);
  EXPECT_NEAR(spin_of(flight.at(4.0 * s)), -per_torque * 0.02, rounding);
  ASSERT_EQ(flight.events().size(), 1U);
  EXPECT_NEAR(flight.events()[0].state.time().value(), 4.0 + 0.02 / M, rounding * 10.0);
  EXPECT_NEAR(spin_of(flight.at(8.0 * s)), 0.0, rounding);
  // From the start.
  const auto at_once = scenario(craft, pulse(craft, of<Wheel>, 0.07 * N_m, -1.0 * s, 2.0 * s),
                                friction(craft, of<Wheel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * N_m_s));
  EXPECT_NEAR(spin_of(propagate(at_once, spinning(craft, 0.1, 0.0), until(1.0)).at(1.0 * s)),
              per_torque * 0.02, rounding);
}

// A spring and Coulomb's friction: each half period, pi (m/k)^(1/2), takes 2 F/k off the stretch, until the
// spring pulls less than the breakaway force.
TEST(Friction, ASpringEndsWhereItNoLongerBreaksAway) {
  const Sat sat;
  constexpr double k = 5.0, F = 0.3, reduced = 1.0 / (1.0 / m_mass + 1.0 / (m_hub + m_panel)), stretch = 0.5;
  const auto rubbing = scenario(sat, spring(sat, of<Mass>, k * (N / m), 0.0 * m),
                                friction(sat, of<Mass>, F * N, F * N, 1.0 * m_s, 0.0 * (N / m_s)));
  const auto flight = propagate(rubbing, start_of(sat, {.length = stretch}), until(10.0));
  const double half = std::numbers::pi * std::sqrt(reduced / k);
  double left = stretch;
  int halves = 0;
  for (; left * k > F; ++halves) left -= 2.0 * F / k;
  ASSERT_EQ(halves, 4);
  const auto events = flight.events();
  ASSERT_EQ(events.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(events[i].state.time().value(), static_cast<double>(i + 1) * half, 10 * rounding);
    EXPECT_NEAR(std::abs(events[i].state.coordinate(of<Mass>).value()),
                std::abs(stretch - 2.0 * F / k * static_cast<double>(i + 1)), 10 * rounding);
  }
  EXPECT_EQ(flight.held<StickSlip<Mass>>(10.0 * s).slips, 0);
  EXPECT_NEAR(flight.at(10.0 * s).coordinate(of<Mass>).value(), left, 10 * rounding);
}

// A stuck hinge transmits the torque that turns the panel with the hub; the reaction of the accelerated hub
// breaks it.
TEST(Friction, AHingeBreaksAwayByTheMotionOfItsParent) {
  const Sat sat;
  constexpr double M = 0.3, J = J_hub - J_wheel + J_mass;
  const auto at = [&](double torque) {
    const auto pushed = scenario(sat, friction(sat, of<Panel>, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * N_m_s),
                                 pulse(sat, of<Hub>, torque * N_m * unit_z(in<Hub>), 1.0 * s, 9.0 * s));
    return propagate(pushed, start_of(sat, {}), until(2.0)).at(2.0 * s);
  };
  constexpr double limit = M * (J + J_panel) / J_panel;  // J_panel alpha = M
  EXPECT_EQ(at(0.999 * limit).speed(of<Panel>).value(), 0.0);
  EXPECT_NEAR(rate_of(at(0.999 * limit)), 0.999 * limit / (J + J_panel), rounding);
  const auto broken = at(-1.2 * limit);
  EXPECT_NEAR(rate_of(broken), (-1.2 * limit + M) / J, rounding);
  EXPECT_NEAR(broken.speed(of<Panel>).value(), -M / J_panel - (-1.2 * limit + M) / J, rounding);
}

// Two stuck joints and a stuck wheel on one craft: one breaks away, the others are stuck to what moves.
TEST(Friction, SeveralStickOnOneCraft) {
  const Sat sat;
  const auto rub = [&](auto on, double M) {
    return friction(sat, on, M * N_m, M * N_m, 1.0 * rad_s, 0.0 * N_m_s);
  };
  const auto driven = scenario(sat, rub(of<Panel>, 0.3), rub(of<Wheel>, 0.2),
                               friction(sat, of<Mass>, 1.0 * N, 1.0 * N, 1.0 * m_s, 0.0 * (N / m_s)),
                               pulse(sat, of<Wheel>, 0.5 * N_m, 1.0 * s, 2.0 * s));
  const auto end = propagate(driven, start_of(sat, {}), until(2.0)).at(2.0 * s);
  constexpr double J_rest = J_hub - J_wheel + J_mass + J_panel;
  EXPECT_NEAR(spin_of(end), 0.3 * (1.0 / J_wheel + 1.0 / J_rest), 10 * rounding);
  EXPECT_EQ(end.speed(of<Panel>).value(), 0.0);
  EXPECT_EQ(end.speed(of<Mass>).value(), 0.0);
}

// The accelerations are those of all joints: they are solved once for all zeros that see an instant, and only
// while something sticks.
TEST(Friction, SeveralThatStickCostNoMoreThanOne) {
  const Sat sat;
  const auto wheel = friction(sat, of<Wheel>, 0.2 * N_m, 0.2 * N_m, 1.0 * rad_s, 0.0 * N_m_s);
  const auto panel = friction(sat, of<Panel>, 0.3 * N_m, 0.3 * N_m, 1.0 * rad_s, 0.0 * N_m_s);
  const auto mass = friction(sat, of<Mass>, 1.0 * N, 1.0 * N, 1.0 * m_s, 0.0 * (N / m_s));
  const auto motor = pulse(sat, of<Wheel>, 0.1 * N_m, 1.0 * s, 2.0 * s);
  std::size_t calls = 0;
  const auto counting = [&calls](const Now<Sat>&, Forces<Sat>&) { ++calls; };
  // The loads are called for each rate, and besides for each instant that is solved for the zeros.
  const auto besides = [&](double spin, const auto&... rubbing) {
    calls = 0;
    const auto flight = propagate(scenario(sat, rubbing..., motor, counting),
                                  start_of(sat, {.spin = spin, .hub_rate = 0.1}), until(3.0));
    EXPECT_EQ(flight.events().size(), 0U);
    return calls - flight.solution().statistics().rhs_evaluations;
  };
  const std::size_t of_one = besides(0.0, wheel);
  EXPECT_GT(of_one, 0U);
  EXPECT_EQ(besides(0.0, wheel, panel, mass), of_one);
  EXPECT_EQ(besides(50.0, wheel), 0U);
}

TEST(Friction, RefusesBadInput) {
  const Sat sat;
  const auto complaint = [&](double coulomb, double breakaway, double u_s, double c) {
    return message<BadInput>(
        [&] { friction(sat, of<Wheel>, coulomb * N_m, breakaway * N_m, u_s * rad_s, c * N_m_s); });
  };
  const std::string on_wheel = "friction on " + frame_name<Wheel>();
  EXPECT_EQ(complaint(-1.0, 1.0, 1.0, 0.0),
            on_wheel + ": the Coulomb effort is -1 N m; it must not be negative");
  EXPECT_EQ(complaint(0.0, 0.0, 1.0, 0.0), on_wheel + ": the breakaway effort is 0 N m; it must be positive");
  EXPECT_EQ(complaint(2.0, 1.0, 1.0, 0.0),
            on_wheel + ": the breakaway effort is 1 N m, less than the Coulomb effort, 2 N m");
  EXPECT_EQ(complaint(1.0, 1.0, 0.0, 0.0), on_wheel + ": the Stribeck speed is 0 rad/s; it must be positive");
  EXPECT_EQ(complaint(1.0, 1.0, 1.0, std::nan("")), on_wheel + ": the viscous damping is nan SI units");
}

TEST(Springs, RefuseBadInput) {
  const Sat sat;
  const double nan = std::nan("");
  const std::string panel = frame_name<Panel>();
  EXPECT_EQ(message<BadInput>([&] { spring(sat, of<Panel>, nan * N_m / rad, 0.0 * rad); }),
            "spring on " + panel + ": the stiffness is nan SI units");
  EXPECT_EQ(message<BadInput>([&] { spring(sat, of<Panel>, 1.0 * N_m / rad, nan * rad); }),
            "spring on " + panel + ": the place of rest is nan rad");
  EXPECT_EQ(message<BadInput>([&] { damper(sat, of<Panel>, nan * N_m_s); }),
            "damper on " + panel + ": the damping is nan SI units");
}

}  // namespace
}  // namespace vectrix_test::three_parts::friction_test
