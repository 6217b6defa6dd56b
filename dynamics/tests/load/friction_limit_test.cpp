#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vectrix/dynamics/load/friction.hpp>
#include <vectrix/dynamics/load/of_time.hpp>
#include <vectrix/dynamics/load/pulse.hpp>

#include "load/three_parts.hpp"
#include "testing/trials.hpp"

// Friction where an effort is as large as the breakaway effort, to the last digit.
namespace vectrix_test::three_parts::friction_limit_test {
namespace {

const auto N_m_s = N_m / rad_s;
constexpr double infinite = std::numeric_limits<double>::infinity();
/// A time since 1970, and what its rounding is.
constexpr double late = 8e8, late_rounding = 0x1p-23;
constexpr double few_digits = 1e-15;  // of a torque near 1

struct Law {
  double M_c, M_s;
};
/// In the last two M_c + (M_s - M_c) is not M_s: it rounds up, and down.
constexpr Law laws[] = {{0.05, 0.05}, {0.0, 0.05}, {0.04, 0.11}, {0.05, 0.21}};
static_assert(0.04 + (0.11 - 0.04) > 0.11 && 0.05 + (0.21 - 0.05) < 0.21);

auto rub(const Sat& sat, auto on, const Law& law) {
  return friction(sat, on, law.M_c * N_m, law.M_s * N_m, 1.0 * rad_s, 0.0 * N_m_s);
}
double wheel_of(const CraftState<Sat>& state) {
  return state.spin(of<Wheel>).value();
}
double panel_of(const CraftState<Sat>& state) {
  return state.speed(of<Panel>).value();
}

// A motor's torque that is M_s does not move the wheel, nor does one that is less by one digit; one that is
// more by one digit moves it, its own way alone. It is at rest when the torque ends.
TEST(FrictionLimit, AWheelSticksUpToTheLimitAndSlipsAboveIt) {
  const Sat sat;
  for (const Law& law : tried(laws))
    for (const double begin : {0.0, late})
      for (const double sign : {1.0, -1.0})
        for (const double before : {0.0, 1.0}) {
          const auto run = [&](double size) {
            return propagate(
                scenario(sat, rub(sat, of<Wheel>, law),
                         pulse(sat, of<Wheel>, sign * size * N_m, (begin + before) * s, (begin + 10.0) * s)),
                start_of(sat, {.time = begin}), until(begin + 20.0));
          };
          for (const double size : {law.M_s, std::nextafter(law.M_s, 0.0)}) {
            const auto flight = run(size);
            EXPECT_EQ(flight.events().size(), 0U);
            for (const double t : {0.0, before, 5.0, 10.0, 15.0, 20.0}) {
              EXPECT_EQ(wheel_of(flight.at((begin + t) * s)), 0.0);
              EXPECT_EQ(flight.template held<StickSlip<Wheel>>((begin + t) * s).slips, 0);
            }
          }
          const auto flight = run(std::nextafter(law.M_s, infinite));
          for (const double t : {before, 2.0, 5.0, 9.0}) {
            EXPECT_EQ(flight.template held<StickSlip<Wheel>>((begin + t) * s).slips, sign);
            EXPECT_GE(sign * wheel_of(flight.at((begin + t) * s)), 0.0);
          }
          EXPECT_GT(sign * wheel_of(flight.at((begin + 9.0) * s)), 0.0);
          const double braking = law.M_s * (1.0 / J_wheel + 1.0 / J_rest);
          EXPECT_NEAR(wheel_of(flight.at((begin + 20.0) * s)), 0.0, braking * late_rounding);
          EXPECT_EQ(flight.template held<StickSlip<Wheel>>((begin + 20.0) * s).slips, 0);
        }
}

// A wheel came to rest within the rounding of the time. A torque above M_s for two seconds then does not undo
// even this: friction must not drive it on when the torque is less again.
TEST(FrictionLimit, AWheelThatCameToRestIsNotDrivenOn) {
  const Sat sat;
  const Law law{0.02, 0.05};
  const double braking = law.M_s * (1.0 / J_wheel + 1.0 / J_rest);
  for (const double begin : {0.0, late})
    for (const double sign : {1.0, -1.0})
      for (const double above : {1e-14, 1e-12, 1e-10, 1e-8}) {
        const auto torque = [=](Quantity<si::time> t) {
          const double x = t.value() - begin - 20.0;
          return sign * (law.M_s + above * (1.0 - x * x)) * N_m;
        };
        auto how = until(begin + 60.0);
        how.maximum_step = 0.25 * s;
        const auto flight =
            propagate(scenario(sat, rub(sat, of<Wheel>, law), of_time(sat, of<Wheel>, torque),
                               pulse(sat, of<Wheel>, -sign * law.M_s * N_m, begin * s, (begin + 10.0) * s)),
                      start_of(sat, {.time = begin, .spin = sign * 0.5}), how);
        const auto end = (begin + 60.0) * s;
        EXPECT_EQ(flight.template held<StickSlip<Wheel>>(end).slips, 0) << begin << ' ' << above;
        EXPECT_NEAR(wheel_of(flight.at(end)), 0.0, 2.0 * braking * late_rounding) << begin << ' ' << above;
      }
}

// The panel is accelerated by its hinge: what is left of the torque beyond M_s is rounding. It slips that way
// or stays; when the hub is no longer pushed it comes to rest.
TEST(FrictionLimit, AHingeNearTheLimitNeverMovesTheOtherWay) {
  const Sat sat;
  constexpr double M = 0.3, J = J_rest, limit = M * (J + J_panel) / J_panel;
  for (const double begin : {0.0, late})
    for (const double sign : {1.0, -1.0})
      for (int digits = -4; digits <= 4; ++digits) {
        const double torque = sign * limit * (1.0 + digits * std::numeric_limits<double>::epsilon());
        const auto flight = propagate(scenario(sat, rub(sat, of<Panel>, {M, M}),
                                               pulse(sat, of<Hub>, torque * N_m * unit_z(in<Hub>),
                                                     (begin + 1.0) * s, (begin + 10.0) * s)),
                                      start_of(sat, {.time = begin}), until(begin + 12.0));
        for (double t = 0.0; t < 10.0; t += 0.5)
          EXPECT_LE(sign * panel_of(flight.at((begin + t) * s)), 0.0) << digits;
        const auto end = (begin + 12.0) * s;
        EXPECT_EQ(flight.template held<StickSlip<Panel>>(end).slips, 0) << digits;
        EXPECT_NEAR(panel_of(flight.at(end)), 0.0, M * (1.0 / J_panel + 1.0 / J) * late_rounding);
      }
}

// A torque on the hub that grows slowly through the limit: the hinge breaks away then, though what is left
// beyond M_s is rounding at first.
TEST(FrictionLimit, AGrowingTorqueOnTheHubBreaksAHinge) {
  const Sat sat;
  constexpr double M = 0.3, J = J_rest, limit = M * (J + J_panel) / J_panel;
  for (const double begin : {0.0, late})
    for (const double sign : {1.0, -1.0})
      for (const double growth : {0.3, 0.03, 1e-6}) {
        const auto torque = [=](Quantity<si::time> t) {
          return sign * (limit + growth * (t.value() - begin - 5.0)) * N_m * unit_z(in<Hub>);
        };
        // The torque rounds with the time: no step can be better.
        const double tolerance = begin == 0.0 ? 1e-13 : 1e-8;
        const auto flight =
            propagate(scenario(sat, rub(sat, of<Panel>, {M, M}), of_time(sat, of<Hub>, torque)),
                      start_of(sat, {.time = begin}), until(begin + 10.0, tolerance));
        ASSERT_EQ(flight.events().size(), 1U) << growth;
        EXPECT_EQ(flight.events()[0].name, frame_name<Panel>() + " breaks away");
        EXPECT_NEAR(flight.events()[0].state.time().value(), begin + 5.0,
                    late_rounding + few_digits * limit / growth);
        // The hub alone is accelerated by what is beyond the limit.
        EXPECT_NEAR(sign * panel_of(flight.at((begin + 10.0) * s)), -growth * 12.5 / J, 10.0 * tolerance);
      }
}

// Jumps of torques at, one digit around, and far from the limit, on two joints at once: friction never drives
// a joint the way it moves, but for what rounds in time when it comes to rest.
TEST(FrictionLimit, FrictionAlwaysOpposes) {
  const Sat sat;
  const Law law{0.02, 0.05};
  std::mt19937 random(7);
  for (const double begin : {0.0, late})
    for (int run = 0; run < trials(40); ++run) {
      const auto any = [&](auto on) {
        const double factors[] = {1.0, 1.0 + 0x1p-52, 1.0 - 0x1p-53, 0.0, 0.5, 3.0};
        const auto one = [&](double t) {
          const double torque = (random() % 2 == 0 ? 1.0 : -1.0) * factors[random() % 6] * law.M_s;
          return pulse(sat, on, torque * N_m, (begin + t) * s,
                       (begin + t + 1.0 + static_cast<double>(random() % 3)) * s);
        };
        return std::array{one(0.0), one(2.0), one(4.0)};
      };
      const auto wheel = any(of<Wheel>);
      const auto panel = any(of<Panel>);
      const auto flight =
          propagate(scenario(sat, rub(sat, of<Wheel>, law), rub(sat, of<Panel>, law), wheel[0], wheel[1],
                             wheel[2], panel[0], panel[1], panel[2]),
                    start_of(sat, {.time = begin, .rate = 0.1 * (run % 3 - 1)}), until(begin + 60.0));
      const double left = 4.0 * law.M_s * (1.0 / J_wheel + 1.0 / J_panel) * late_rounding;
      for (double t = begin; t < begin + 60.0; t += 0.1) {
        const auto at = flight.at(t * s);
        EXPECT_GE(flight.template held<StickSlip<Wheel>>(t * s).slips * wheel_of(at), -left);
        EXPECT_GE(flight.template held<StickSlip<Panel>>(t * s).slips * panel_of(at), -left);
      }
      EXPECT_NEAR(wheel_of(flight.at((begin + 60.0) * s)), 0.0, left) << run;
      EXPECT_NEAR(panel_of(flight.at((begin + 60.0) * s)), 0.0, left) << run;
    }
}

}  // namespace
}  // namespace vectrix_test::three_parts::friction_limit_test
