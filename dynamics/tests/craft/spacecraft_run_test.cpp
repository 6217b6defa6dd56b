#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "craft/random_spacecraft.hpp"

// Runs of a typed spacecraft: what the laws keep, a load that jumps, springs and dampers.
namespace vectrix_test::spacecraft_test::spacecraft_run_test {
namespace {

using namespace vectrix;

constexpr double tolerance = 1e-13;

CraftPropagation until(const Quantity<si::time>& end) {
  return {.end = end,
          .relative_tolerance = tolerance,
          .absolute_tolerances = {tolerance * rad, tolerance * rad_s, tolerance * si::metre, tolerance * m_s,
                                  tolerance}};
}
/// What a law may lose: each step changes each number y by tolerance (1 + |y|), and a sum of products of such
/// numbers, of a size well above 1, by about as much of it.
double lost(const auto& flight, double size) {
  return static_cast<double>(flight.solution().statistics().steps) * tolerance * size;
}
/// What a constant torque that gives a rate may lose to rounding: a step adds a sum of sixteen products.
double rounded(const auto& flight, double rate) {
  return 16.0 * static_cast<double>(flight.solution().statistics().steps) *
         std::numeric_limits<double>::epsilon() * rate;
}

TEST(SpacecraftRun, ARunKeepsWhatTheLawsKeep) {
  RandomCraft random(20260715);
  const Every craft(random);
  const auto start = random_state(craft, random);
  const auto flight = propagate(scenario(craft), start, until(5.0 * s));
  const auto before = motion(craft, start);
  const auto after = motion(craft, flight.at(5.0 * s));
  const auto change = [&](const auto& p, const auto& q) { return (p - q).coordinates().norm(); };
  EXPECT_LE(change(before.momentum(), after.momentum()),
            lost(flight, before.momentum().coordinates().norm()));
  EXPECT_LE(change(before.angular_momentum(), after.angular_momentum()),
            lost(flight, before.angular_momentum().coordinates().norm()));
  EXPECT_LE(after.energy(), before.energy());  // the modes are damped
  EXPECT_GT(std::abs(after.state().coordinate(of<Boom>).value() - start.coordinate(of<Boom>).value()), 0.01);

  const Turning rigid;
  const auto R = moving<Gcrf, Hub>(random).turning;
  const auto first =
      state(rigid, 0.0 * s, R, starts(of<Boom>, 0.3 * rad, 0.5 * rad_s), spins(of<WheelOfHub>, 9.0 * rad_s));
  const auto turned = propagate(scenario(rigid), first, until(20.0 * s));
  const auto then = motion(rigid, first), now = motion(rigid, turned.at(20.0 * s));
  EXPECT_NEAR(then.energy().value(), now.energy().value(), lost(turned, then.energy().value()));
  EXPECT_LE(change(then.angular_momentum(), now.angular_momentum()),
            lost(turned, then.angular_momentum().coordinates().norm()));
}

TEST(SpacecraftRun, ARateWhoseTorqueUnderflowsIsRefused) {
  const Turning craft;
  const double slow = std::ldexp(1.0, -545);
  const auto start = state(
      craft, 0.0 * s,
      MovingDcm{aligned(to<Gcrf>, from<Hub>),
                angular_velocity(of<Hub>, relative_to<Gcrf>,
                                 vector(in<Hub>, 0.1 * slow * rad_s, slow * rad_s, 0.2 * slow * rad_s))},
      starts(of<Boom>, 0.3 * rad, 0.0 * rad_s), spins(of<WheelOfHub>, 0.0 * rad_s));
  try {
    propagate(scenario(craft), start, until(20.0 / slow * s));
    ADD_FAILURE() << "not refused";
  } catch (const std::exception& failure) {
    EXPECT_NE(std::string(failure.what()).find("underflows, J w^2 = "), std::string::npos) << failure.what();
  }
}

// A hub of inertia J alone, with a torque that acts from 1 s to 3 s: w = M t / J, exactly.
TEST(SpacecraftRun, ALoadJumpsWithAHeldValue) {
  // The mass of a joined body, which has a name of its own.
  const auto half = [](auto part, double x) {
    using B = decltype(part);
    return mass_properties(0.5 * si::kilogram,
                           displacement(of<CentreOfMassOf<B>>, relative_to<Hub>,
                                        vector(in<Hub>, x * si::metre, 0.0 * si::metre, 0.0 * si::metre)),
                           aligned(to<Hub>, from<B>) *
                               inertia_from_principal_moments(in<B>, 1.0 * kg_m2, 0.5 * kg_m2, 0.5 * kg_m2));
  };
  const auto mass_of_both = join(of<Both>, half(Box{}, 1.0), half(Probe{}, -1.0));
  const auto craft = spacecraft(body(mass_of_both, turning_in<Gcrf>));
  using Ball = std::remove_const_t<decltype(craft)>;
  static_assert(Ball::state_size == 7);
  const auto start = state(
      craft, 0.0 * s, moving_dcm(aligned(to<Gcrf>, from<Hub>), at_rest(of<Hub>, relative_to<Gcrf>, in<Hub>)));
  using Torque = Vector<Hub, si::torque>;
  const Torque on = 0.4 * si::newton_metre * unit_z(in<Hub>), off = zero<si::torque>(in<Hub>);
  const auto pulse = scenario(
      craft, held(off), at_times({1.0 * s}, becomes(on)), at_times({3.0 * s}, becomes(off)),
      [](const Now<Ball>&, Forces<Ball>& forces, const Torque& torque) { forces.torque(of<Hub>, torque); });
  const auto flight = propagate(pulse, start, until(4.0 * s));
  EXPECT_EQ(flight.at(1.0 * s).turning().angular_velocity.coordinates().norm(), 0.0);
  EXPECT_NEAR(flight.at(2.0 * s).turning().angular_velocity.z().value(), 0.2, rounded(flight, 0.4));
  EXPECT_NEAR(flight.at(4.0 * s).turning().angular_velocity.z().value(), 0.4, rounded(flight, 0.4));
  EXPECT_THROW(flight.at(4.1 * s), BadInput);
}

TEST(SpacecraftRun, ASpringAndADamperAreEfforts) {
  const Turning craft;
  const auto R = moving_dcm(aligned(to<Gcrf>, from<Hub>), at_rest(of<Hub>, relative_to<Gcrf>, in<Hub>));
  const auto start =
      state(craft, 0.0 * s, R, starts(of<Boom>, 0.2 * rad, 0.3 * rad_s), spins(of<WheelOfHub>, 0.0 * rad_s));
  const auto k = 3.0 * si::newton_metre / rad;
  const auto c = 0.5 * si::newton_metre / rad_s;
  const auto sprung = motion(craft, start, spring(craft, of<Boom>, k, 0.1 * rad), damper(craft, of<Boom>, c));
  const auto pushed = motion(craft, start, [](const auto&, auto& forces) {
    forces.effort(of<Boom>, -(3.0 * 0.1 + 0.5 * 0.3) * si::newton_metre);
  });
  constexpr double of_sums = 1e-14;  // some fifty roundings of numbers below 1
  for (std::size_t i = 0; i < Turning::state_size; ++i)
    EXPECT_NEAR(sprung.rates()[i], pushed.rates()[i], of_sums);
}

}  // namespace
}  // namespace vectrix_test::spacecraft_test::spacecraft_run_test
