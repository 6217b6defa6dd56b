#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vectrix/dynamics/craft/conservation.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/dynamics/load/prescribed.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "craft/random_spacecraft.hpp"
#include "load/sine.hpp"
#include "load/three_parts.hpp"

// A gimbal whose motion is a given function of time, about both axes or one.
namespace vectrix_test::prescribed_gimbal_test {
namespace {

using namespace vectrix;
using namespace vectrix_test::short_units;
using vectrix_test::RandomCraft;

constexpr double tolerance = 1e-13;
constexpr auto rad_s2 = rad_s / s;

using spacecraft_test::axis;
using spacecraft_test::Gcrf;
using spacecraft_test::mass;
using spacecraft_test::moving;
using spacecraft_test::place;
using spacecraft_test::rounding_of_craft;

struct Hub : moving_frame {};
struct Mirror : moving_frame {};
struct Boom : moving_frame {};
struct Wheel : named_point {};

/// A mirror on a gimbal, a boom that swings freely, a wheel: of random numbers.
auto make_scanner(RandomCraft& random) {
  return spacecraft(body(mass<Hub>(random, 10.0), free_in<Gcrf>),
                    body(mass<Boom>(random, 2.0), hinge(place<Hub, Boom>(random), axis<Boom>(random))),
                    body(mass<Mirror>(random, 2.0),
                         gimbal(place<Boom, Mirror>(random), axis<Mirror>(random), axis<Mirror>(random))),
                    rotor(of<Wheel>, axis<Hub>(random), 0.01 * kg_m2));
}
struct Scanner : decltype(make_scanner(std::declval<RandomCraft&>())) {
  explicit Scanner(RandomCraft& random) : decltype(make_scanner(random))(make_scanner(random)) {}
};
constexpr std::array<Sine, 2> raster{Sine{0.5, 4.0, 0.2, 3.0}, Sine{0.3, 1.5, -0.4, 2.0}};
auto both_axes(const Quantity<si::time>& t) {
  return std::array{raster[0].turning(t.value()), raster[1].turning(t.value())};
}
CraftState<Scanner> start_of(const Scanner& craft, RandomCraft& random, double t) {
  return state(craft, t * s, moving<Gcrf, Hub>(random), starts(of<Boom>, 0.3 * rad, -0.2 * rad_s),
               starts(of<Mirror>, raster[0].q(t) * rad, raster[0].u(t) * rad_s, raster[1].q(t) * rad,
                      raster[1].u(t) * rad_s),
               spins(of<Wheel>, 30.0 * rad_s));
}

// The named craft gives accelerations only: they are the same to the engine.
TEST(PrescribedGimbal, AGimbalHasTheMotionOfTheNamedCraft) {
  RandomCraft random(20261129);
  for (int trial = 0; trial < 10; ++trial) {
    const Scanner craft(random);
    const NamedSpacecraft same(plain(craft));
    const auto start = start_of(craft, random, 1.0 + 0.3 * trial);
    const auto found = motion(craft, start, prescribed(craft, of<Mirror>, both_axes));
    const auto mirror = frame_name<Mirror>();
    const auto wanted = same.motion(same.state(start.numbers()), start.time(), {},
                                    {prescribed(mirror, [](const Quantity<si::time>& t) {
                                      const auto given = both_axes(t);
                                      return std::array{given[0].acceleration, given[1].acceleration};
                                    })});
    for (std::size_t i = 0; i < Scanner::state_size; ++i) EXPECT_EQ(found.rates()[i], wanted.rates()[i]) << i;
    const auto drive = found.holding_effort(of<Mirror>);
    EXPECT_EQ(drive[0], wanted.holding_torque(Of(mirror), 1));
    EXPECT_EQ(drive[1], wanted.holding_torque(Of(mirror), 2));
    EXPECT_TRUE(contains(message<BadInput>([&] { (void)wanted.holding_torque(Of(mirror), 3); }),
                         "its joint has no axis 3"));
    EXPECT_TRUE(contains(message<BadInput>([&] { (void)wanted.holding_force(Of(mirror)); }),
                         "a force along an axis on \"" + mirror + "\", whose joint is a gimbal"));
    EXPECT_NEAR(found.holding_effort(of<Boom>).value(), 0.0, rounding_of_craft);
  }
}

// A gimbal of which one axis is driven, and a wheel, as those of the named craft; free about the other axis.
TEST(PrescribedGimbal, AGimbalIsDrivenAboutOneAxis) {
  RandomCraft random(20261202);
  for (int trial = 0; trial < 10; ++trial) {
    const Scanner craft(random);
    const NamedSpacecraft same(plain(craft));
    const double t_0 = 1.0 + 0.3 * trial;
    const auto start = start_of(craft, random, t_0);
    const auto wheel = [](const Quantity<si::time>&) { return RotorMotion{30.0 * rad_s, 2.0 * rad_s2}; };
    const auto check = [&]<int axis>(AboutAxis<axis>) {
      const auto& sine = raster[axis - 1];
      const auto found = motion(craft, start, prescribed(craft, of<Mirror>, about_axis<axis>, turning(sine)),
                                prescribed(craft, of<Wheel>, wheel));
      const auto drive = found.holding_effort(of<Mirror>);
      const auto free = drive[2 - axis];
      EXPECT_NEAR(free.value(), 0.0, rounding_of_craft);
      const auto pushed = motion(craft, start, [&](const Now<Scanner>&, Forces<Scanner>& forces) {
        forces.effort(of<Mirror>, drive[0], drive[1]);
        forces.motor(of<Wheel>, found.holding_effort(of<Wheel>));
      });
      const std::string mirror = frame_name<Mirror>(), rotor = frame_name<Wheel>();
      const auto named = same.motion(
          same.state(start.numbers()), start.time(), {},
          {prescribed(mirror, axis, [&](const Quantity<si::time>& t) { return sine.a(t.value()) * rad_s2; }),
           prescribed(rotor, [](const Quantity<si::time>&) { return 2.0 * rad_s2; })});
      EXPECT_EQ(named.holding_torque(Of(mirror), axis), drive[axis - 1]);
      EXPECT_EQ(named.holding_torque(Of(rotor)), found.holding_effort(of<Wheel>));
      for (std::size_t i = 0; i < Scanner::state_size; ++i) {
        EXPECT_EQ(found.rates()[i], named.rates()[i]) << i;
        EXPECT_NEAR(pushed.rates()[i], found.rates()[i],
                    rounding_of_craft * (1.0 + std::abs(found.rates()[i])))
            << i;
      }
    };
    check(about_axis<1>);
    check(about_axis<2>);
    const auto both = motion(craft, start, prescribed(craft, of<Mirror>, both_axes));
    const auto each = motion(craft, start, prescribed(craft, of<Mirror>, about_axis<2>, turning(raster[1])),
                             prescribed(craft, of<Mirror>, about_axis<1>, turning(raster[0])));
    EXPECT_EQ(each.rates(), both.rates());
  }
}

TEST(PrescribedGimbal, AnAxisThatDisagreesIsRefused) {
  RandomCraft random(20261203);
  const Scanner craft(random);
  const auto refused = [&](const auto&... drives) {
    return message<BadInput>([&] {
      (void)propagate(scenario(craft, drives...), start_of(craft, random, 1.0), three_parts::until(2.0));
    });
  };
  const auto first = prescribed(craft, of<Mirror>, about_axis<1>, turning(raster[0]));
  EXPECT_TRUE(contains(refused(prescribed(craft, of<Mirror>, about_axis<2>, turning(raster[0]))),
                       "Mirror, axis 2 at 1 s: the coordinate is "));
  EXPECT_TRUE(
      contains(message<BadInput>([&] { (void)motion(craft, start_of(craft, random, 1.0), first, first); }),
               "the joint of " + frame_name<Mirror>() + " is driven, and "));
}

// With the torques of the drive as efforts of a free gimbal, it moves as it is told to.
TEST(PrescribedGimbal, TheTorquesOfTheDriveMoveAFreeGimbalAlike) {
  RandomCraft random(20261130);
  for (int trial = 0; trial < 10; ++trial) {
    const Scanner craft(random);
    const auto start = start_of(craft, random, 1.0 + 0.3 * trial);
    const auto driven = motion(craft, start, prescribed(craft, of<Mirror>, both_axes));
    const auto drive = driven.holding_effort(of<Mirror>);
    const auto pushed = motion(craft, start, [&](const Now<Scanner>&, Forces<Scanner>& forces) {
      forces.effort(of<Mirror>, drive[0], drive[1]);
    });
    for (std::size_t i = 0; i < Scanner::state_size; ++i)
      EXPECT_NEAR(pushed.rates()[i], driven.rates()[i],
                  rounding_of_craft * (1.0 + std::abs(driven.rates()[i])))
          << i;
  }
}

// The drive is inside the craft: momentum and angular momentum are kept, and its power is what the energy
// changes by.
TEST(PrescribedGimbal, ADriveKeepsMomentumAndGivesTheEnergy) {
  RandomCraft random(20261201);
  const Scanner craft(random);
  const auto flight = scenario(craft, prescribed(craft, of<Mirror>, both_axes));
  constexpr double from = 1.0, until = 3.0;
  const auto run = propagate(flight, start_of(craft, random, from), three_parts::until(until, tolerance));
  const double kept = 2.0 * tolerance * static_cast<double>(run.solution().statistics().steps) * 10.0;
  EXPECT_LE(largest_change(craft, run, [](const Now<Scanner>& now) { return now.momentum(); }), kept);
  EXPECT_LE(largest_change(craft, run, [](const Now<Scanner>& now) { return now.angular_momentum(); }), kept);

  const auto power = [&](double t) {
    const auto now = motion_at(flight, run, t * s);
    const auto drive = now.holding_effort(of<Mirror>);
    const auto speed = now.state().speed(of<Mirror>);
    return drive[0].value() * speed[0].value() + drive[1].value() * speed[1].value();
  };
  // Simpson's rule: (W h)^4 / 180 of the power, some ten watts, for the harmonics of some 10 rad/s.
  constexpr int steps = 2000;
  constexpr double h = (until - from) / steps, of_simpson = 1e-8;
  double work = 0.0, largest = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double p = power(from + i * h);
    largest = std::max(largest, std::abs(p));
    work += h / 3.0 * (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * p;
  }
  const auto energy = [&](double t) { return motion_at(flight, run, t * s).energy().value(); };
  EXPECT_GT(largest, 0.5);
  EXPECT_NEAR(energy(until) - energy(from), work, of_simpson * largest);
}

}  // namespace
}  // namespace vectrix_test::prescribed_gimbal_test
