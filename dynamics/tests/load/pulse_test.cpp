#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "load/three_parts.hpp"

// Pulses and functions of time, on bodies, joints and rotors.
namespace vectrix_test::three_parts::pulse_test {
namespace {

constexpr double rounding = 1e-13;  // of numbers near 1, in a run of some ten steps

double rate_of(const CraftState<Sat>& state) {
  return state.turning().angular_velocity.z().value();
}

double pulse_integral(double t, double from, double until) {
  return std::min(std::max(t - from, 0.0), until - from);
}

// Two pulses on one body, which overlap: w = M1/J (t - t1) + M2/J (t - t2) while they act.
TEST(Pulse, TheRateIsTheIntegralOfThePulses) {
  const Sat sat;
  constexpr double M1 = 0.3, M2 = -0.8;
  const auto pushed =
      scenario(sat, pulse(sat, of<Hub>, M1 * N_m * unit_z(in<Inertial>), 0.7 * s, 1.9 * s),
               pulse(sat, of<Hub>, torque_about<Hub>(M2 * N_m * unit_z(in<Panel>)), 1.1 * s, 2.3 * s));
  const auto flight = propagate(pushed, start_of(sat, {.hub_rate = 0.2}), until(3.0));
  EXPECT_EQ(flight.solution().segment_count(), 5U);
  // The wheel and the panel are free about z.
  constexpr double J = J_hub - J_wheel + J_mass;
  for (double t = 0.05; t < 3.0; t += 0.1)
    EXPECT_NEAR(rate_of(flight.at(t * s)),
                0.2 + (M1 * pulse_integral(t, 0.7, 1.9) + M2 * pulse_integral(t, 1.1, 2.3)) / J, rounding);
  const auto alpha = [&](double t) {
    return motion_at(pushed, flight, t * s).angular_acceleration(of<Hub>, in<Hub>).z().value();
  };
  EXPECT_NEAR(alpha(0.7), M1 / J, rounding);
  EXPECT_NEAR(alpha(1.5), (M1 + M2) / J, rounding);
  EXPECT_NEAR(alpha(2.3), 0.0, rounding);
}

// The run starts before, at the start of, in, at the end of or after the pulse; it may end in it.
TEST(Pulse, ARunMayStartOrEndInAPulse) {
  const Sat sat;
  constexpr double torque = 0.3, from = 1.0, until_ = 2.5, J = J_hub - J_wheel + J_mass;
  const auto pushed =
      scenario(sat, pulse(sat, of<Hub>, torque * N_m * unit_z(in<Hub>), from * s, until_ * s));
  for (const double begin : {0.3, 1.0, 1.7, 2.5, 3.0}) {
    for (const double end : {0.9, 1.0, 2.0, 2.5, 4.0}) {
      if (end <= begin) continue;
      const auto flight = propagate(pushed, start_of(sat, {.time = begin}), until(end));
      EXPECT_NEAR(rate_of(flight.at(end * s)),
                  torque / J * (pulse_integral(end, from, until_) - pulse_integral(begin, from, until_)),
                  rounding)
          << begin << ' ' << end;
    }
  }
}

// A load by itself has the accelerations of the forces of the user's own load.
template <class Load>
void expect_same(const Sat& sat, const CraftState<Sat>& at, const auto& parts, const Load& own) {
  const auto wanted = motion(sat, at, own).rates();
  const auto flight = propagate(parts, at, until(at.time().value() + 0.1));
  const auto found = motion_at(parts, flight, at.time()).rates();
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], rounding) << i;
  EXPECT_NE(wanted, motion(sat, at).rates());
}

TEST(Pulse, ActsOnBodiesJointsAndRotors) {
  const Sat sat;
  const auto at = start_of(
      sat,
      {.time = 1.0, .angle = 0.4, .rate = 0.3, .length = 0.2, .velocity = 0.5, .spin = 6.0, .hub_rate = 0.1});
  const auto torque = vector(in<Inertial>, 0.1 * N_m, -0.2 * N_m, 0.3 * N_m);
  const auto force = vector(in<Mass>, 0.4 * N, 0.5 * N, -0.6 * N);
  // The force through a point q of the panel.
  const auto r = displacement(of<Wheel>, relative_to<Panel>, vector(in<Mass>, 0.1 * m, 0.7 * m, -0.3 * m));
  const auto W = shift(force_through<Wheel>(force), -r);
  const auto compare = [&](const auto& own, auto... given) {
    expect_same(sat, at, scenario(sat, pulse(sat, given..., 0.5 * s, 1.5 * s)), own);
  };
  using See = const Now<Sat>&;
  using Put = Forces<Sat>&;
  compare([&](See, Put forces) { forces.torque(of<Panel>, torque); }, of<Panel>, torque);
  compare([&](See, Put forces) { forces.force(of<Nozzle>, force); }, of<Nozzle>, force);
  compare([&](See, Put forces) { forces.force(of<Panel>, r, force); }, of<Panel>, W);
  compare([&](See, Put forces) { forces.effort(of<Panel>, 0.7 * N_m); }, of<Panel>,
          Quantity<si::torque>(0.7 * N_m));
  compare([&](See, Put forces) { forces.effort(of<Mass>, 0.7 * N); }, of<Mass>, Quantity<si::force>(0.7 * N));
  compare([&](See, Put forces) { forces.motor(of<Wheel>, 0.7 * N_m); }, of<Wheel>,
          Quantity<si::torque>(0.7 * N_m));

  const auto compare_at = [&](const auto& own, const auto& load) {
    expect_same(sat, at, scenario(sat, load), own);
  };
  compare_at([&](See now, Put forces) { forces.torque(of<Panel>, now.time().value() * torque); },
             of_time(sat, of<Panel>, [&](Quantity<si::time> t) { return t.value() * torque; }));
  compare_at([&](See now, Put forces) { forces.wrench(of<Panel>, now.time().value() * W); },
             of_time(sat, of<Panel>, [&](const Quantity<si::time>& t) { return t.value() * W; }));
  compare_at([&](See now, Put forces) { forces.motor(of<Wheel>, now.time().value() * N_m); },
             of_time(sat, of<Wheel>, [&](Quantity<si::time> t) { return t.value() * N_m; }));
  compare_at([&](See now, Put forces) { forces.effort(of<Mass>, now.time().value() * N); },
             of_time(sat, of<Mass>, [&](Quantity<si::time> t) { return t.value() * N; }));
}

// J w' = M sin 3t: w = M/(3 J) (1 - cos 3t)
TEST(OfTime, TheRateIsTheIntegralOfTheFunction) {
  const Sat sat;
  const auto shaken = scenario(sat, of_time(sat, of<Hub>, [](Quantity<si::time> t) {
                                 return 0.4 * std::sin(3.0 * t.value()) * N_m * unit_z(in<Hub>);
                               }));
  const auto flight = propagate(shaken, start_of(sat, {}), until(5.0));
  for (double t = 0.5; t <= 5.0; t += 0.5)
    EXPECT_NEAR(rate_of(flight.at(t * s)),
                0.4 / (3.0 * (J_hub - J_wheel + J_mass)) * (1.0 - std::cos(3.0 * t)), 10 * rounding);
}

// Steps of a given length over both jumps of a pulse, in a motion that is not a polynomial.
TEST(Pulse, TheOrderOfTheMethodIsKept) {
  const Sat sat;
  const auto start = start_of(sat, {.rate = 0.5, .velocity = 0.4, .spin = 20.0, .hub_rate = 0.7});
  const auto torque = vector(in<Inertial>, 1.0 * N_m, -2.0 * N_m, 0.5 * N_m);
  const auto held_pulse = scenario(sat, pulse(sat, of<Panel>, torque, 1.03 * s, 2.51 * s));
  const auto across = scenario(sat, of_time(sat, of<Panel>, [&](Quantity<si::time> t) {
                                 return (t >= 1.03 * s && t < 2.51 * s ? 1.0 : 0.0) * torque;
                               }));
  const auto exact = propagate(held_pulse, start, until(4.0)).at(4.0 * s);
  const auto error = [&](const auto& parts, double step) {
    CraftPropagation how = until(4.0, 1e3);  // the steps are the longest allowed
    how.maximum_step = step * s;
    how.method = ode::Method::verner_7;
    const auto end = propagate(parts, start, how).at(4.0 * s);
    double sum = 0.0;
    for (std::size_t i = 0; i < end.numbers().size(); ++i)
      sum += std::abs(end.numbers()[i] - exact.numbers()[i]);
    return sum;
  };
  const auto order = [&](const auto& parts, double halvings) {
    return std::log2(error(parts, 0.2) / error(parts, 0.2 * std::exp2(-halvings))) / halvings;
  };
  EXPECT_GT(order(held_pulse, 2.0), 6.5);
  // What this would see of a pulse by the time; its error varies with the place of the jump in the step.
  EXPECT_LT(order(across, 6.0), 2.0);
}

TEST(Pulse, RefusesBadInput) {
  const Sat sat;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto complaint = [](const auto& call) { return message<BadInput>(call); };
  const auto M = 1.0 * N_m * unit_z(in<Hub>);
  EXPECT_EQ(
      complaint([&] { pulse(sat, of<Hub>, nan * N_m * unit_z(in<Hub>), 0.0 * s, 1.0 * s); }).substr(0, 21),
      "pulse: the load is (n");
  EXPECT_EQ(complaint([&] { pulse(sat, of<Wheel>, nan * N_m, 0.0 * s, 1.0 * s); }),
            "pulse: the load is nan N m");
  EXPECT_EQ(complaint([&] { pulse(sat, of<Hub>, M, nan * s, 1.0 * s); }), "pulse: the start is nan s");
  EXPECT_EQ(complaint([&] { pulse(sat, of<Hub>, M, 0.0 * s, 1.0 / 0.0 * s); }), "pulse: the end is inf s");
  EXPECT_EQ(complaint([&] { pulse(sat, of<Hub>, M, 2.0 * s, 2.0 * s); }),
            "pulse: it starts at 2 s and ends at 2 s");
}

}  // namespace
}  // namespace vectrix_test::three_parts::pulse_test
