#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <string>
#include <vectrix/dynamics/craft/comparison.hpp>
#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/dynamics/load/lockable.hpp>

#include "short_units.hpp"
#include "testing/attitudes.hpp"

// Two runs of one craft whose difference is known in closed form: their starts differ by known numbers, and
// nothing acts.
namespace vectrix_test::comparison_test {
namespace {

using namespace vectrix;
using namespace vectrix_test::short_units;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
struct Arm : moving_frame {};
struct Probe : moving_frame {};
struct Wheel : named_point {};

template <class B> auto ball_of(double mass, double moment) {
  return mass_properties(
      mass * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
      inertia_from_principal_moments(in<B>, moment * kg_m2, moment * kg_m2, moment * kg_m2));
}
template <class B> auto on_hub() {
  return Transform{aligned(to<Hub>, from<B>), coincident(of<B>, relative_to<Hub>, in<Hub>)};
}
auto make_sat() {
  return spacecraft(body(ball_of<Hub>(10.0, 4.0), free_in<Gcrf>),
                    body(ball_of<Arm>(1.0, 0.5), slider(on_hub<Arm>(), unit_x(in<Arm>))),
                    body(ball_of<Probe>(1.0, 0.5), free_joint(on_hub<Probe>())),
                    rotor(of<Wheel>, unit_z(in<Hub>), 0.1 * kg_m2));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

/// What a start has, beyond one in which everything rests.
struct Beyond {
  double turn = 0.0, place = 0.0, speed = 0.0, arm = 0.0, wheel = 0.0, probe_turn = 0.0, probe_speed = 0.0;
};
CraftTrajectory<Sat> run(const Beyond& by, double begin = 1.0, double end = 11.0, double at_place = -1.0,
                         bool dense = true) {
  const Sat sat;
  const auto none = 0.0 * rad_s;
  const auto still = [&](auto b, auto a) {
    using B = decltype(b);
    using A = decltype(a);
    return angular_velocity(of<B>, relative_to<A>, vector(in<B>, none, none, none));
  };
  const MovingTransform<Gcrf, Hub> hub{
      {turned_x(to<Gcrf>, from<Hub>, by.turn * rad), still(Hub{}, Gcrf{})},
      displacement(of<Hub>, relative_to<Gcrf>, vector(in<Gcrf>, by.place * m, 0.0 * m, 0.0 * m)),
      velocity(of<Hub>, relative_to<Gcrf>, observed_from<Gcrf>,
               vector(in<Gcrf>, 0.0 * m_s, by.speed * m_s, 0.0 * m_s))};
  const MovingTransform<Hub, Probe> probe{
      {turned_z(to<Hub>, from<Probe>, by.probe_turn * rad), still(Probe{}, Hub{})},
      displacement(of<Probe>, relative_to<Hub>, vector(in<Hub>, 0.0 * m, 2.0 * m, 0.0 * m)),
      velocity(of<Probe>, relative_to<Hub>, observed_from<Hub>,
               vector(in<Hub>, 0.0 * m_s, 0.0 * m_s, by.probe_speed * m_s))};
  const auto passes = when(
      "passes",
      [at_place](const Now<Sat>& now) {
        return now.position(of<Hub>, relative_to<Gcrf>, in<Gcrf>).coordinates().y() - at_place;
      },
      ode::Direction::rising);
  return propagate(scenario(sat, passes),
                   state(sat, begin * s, hub, starts(of<Arm>, by.arm * m, 0.0 * m_s), starts(probe),
                         spins(of<Wheel>, by.wheel * rad_s)),
                   {.end = end * s,
                    .relative_tolerance = 1e-12,
                    .absolute_tolerances = {1e-12 * rad, 1e-12 * rad_s, 1e-12 * m, 1e-12 * m_s, 1e-12},
                    .dense_output = dense});
}
/// Nothing moves but in a straight line.
constexpr double rounding = 1e-12;

TEST(Comparison, sees_each_quantity_with_its_size_and_time) {
  const Sat sat;
  const Beyond by{.turn = 3e-9, .place = 0.1, .speed = 0.2, .arm = 0.3, .wheel = 5.0, .probe_turn = 0.6};
  const auto found = compare(sat, run({}), run(by));
  EXPECT_EQ(found.from(), 1.0 * s);
  EXPECT_EQ(found.until(), 11.0 * s);
  EXPECT_NEAR(found.attitude(of<Hub>).size.in(rad), 3e-9, 1e-15);  // no digits go to the cosine of an angle
  EXPECT_NEAR(found.rate(of<Hub>).size.in(rad_s), 0.0, rounding);
  EXPECT_NEAR(found.position(of<Hub>).size.in(m), std::hypot(0.1, 0.2 * 10.0), rounding);
  EXPECT_EQ(found.position(of<Hub>).time, 11.0 * s);
  EXPECT_NEAR(found.velocity(of<Hub>).size.in(m_s), 0.2, rounding);
  EXPECT_NEAR(found.coordinate(of<Arm>).size.in(m), 0.3, rounding);
  EXPECT_NEAR(found.speed(of<Arm>).size.in(m_s), 0.0, rounding);
  EXPECT_NEAR(found.attitude(of<Probe>).size.in(rad), 0.6, rounding);
  EXPECT_NEAR(found.rate(of<Probe>).size.in(rad_s), 0.0, rounding);
  EXPECT_NEAR(found.position(of<Probe>).size.in(m), 0.0, rounding);
  EXPECT_NEAR(found.velocity(of<Probe>).size.in(m_s), 0.0, rounding);
  EXPECT_NEAR(found.spin(of<Wheel>).size.in(rad_s), 5.0, rounding);
  // m v^2 / 2 and J_s Omega^2 / 2; m v; J_s Omega about z, and (sum of m r) x v, whose mean place is what
  // counts: x = 0.1 m of 12 kg and 0.3 m of the arm, y = 0 but for the probe at 2 m.
  EXPECT_NEAR(found.energy().size.value(), 0.5 * 12.0 * 0.04 + 0.5 * 0.1 * 25.0, rounding);
  EXPECT_NEAR(found.momentum().size.value(), 12.0 * 0.2, rounding);
  EXPECT_NEAR(found.angular_momentum().size.value(), 0.1 * 5.0 + (12.0 * 0.1 + 0.3) * 0.2,
              1e-7);  // cos(turn)
}

TEST(Comparison, of_equal_runs_is_zero_and_of_a_free_body_has_its_velocity) {
  const Sat sat;
  const auto same = compare(sat, run({.speed = 0.2, .wheel = 5.0}), run({.speed = 0.2, .wheel = 5.0}));
  EXPECT_EQ(same.position(of<Hub>).size, 0.0 * m);
  EXPECT_EQ(same.energy().size.value(), 0.0);
  const auto probe = compare(sat, run({}), run({.probe_speed = 0.5}));
  EXPECT_NEAR(probe.velocity(of<Probe>).size.in(m_s), 0.5, rounding);
  EXPECT_NEAR(probe.position(of<Probe>).size.in(m), 5.0, rounding);
}

TEST(Comparison, is_within_the_span_that_both_have) {
  const Sat sat;
  const auto found = compare(sat, run({.speed = 0.2}, 1.0, 6.0), run({.speed = 0.3}, 1.0, 11.0));
  EXPECT_EQ(found.until(), 6.0 * s);
  EXPECT_NEAR(found.position(of<Hub>).size.in(m), 0.5, rounding);
  EXPECT_THROW((void)compare(sat, run({}, 1.0, 2.0), run({}, 3.0, 4.0)), BadInput);
}

TEST(Comparison, says_which_trajectory_has_no_dense_output) {
  const Sat sat;
  const auto dense = run({.wheel = 5.0}), sparse = run({.speed = 0.2}, 1.0, 11.0, 1.0, false);
  const auto says = [&](const auto& ours, const auto& theirs, const std::string& part) {
    const std::string text = message<BadInput>([&] { (void)compare(sat, ours, theirs); });
    EXPECT_TRUE(text.starts_with("compare: the " + part + " trajectory of ")) << text;
    EXPECT_TRUE(text.ends_with(" s, a node of the other: it was made without dense_output")) << text;
  };
  says(dense, sparse, "second");
  says(sparse, dense, "first");
}

TEST(Comparison, compares_the_times_of_events) {
  const Sat sat;
  // y = v (t - 1 s) passes 1 m at 1 s + 1 m / v.
  const auto found = compare(sat, run({.speed = 0.2}, 1.0, 11.0, 1.0), run({.speed = 0.25}, 1.0, 11.0, 1.0));
  ASSERT_TRUE(found.events());
  EXPECT_NEAR(found.events()->size.in(s), 1.0, rounding);
  EXPECT_NEAR(found.events()->time.in(s), 6.0, rounding);
  EXPECT_FALSE(compare(sat, run({.speed = 0.2}, 1.0, 11.0, 1.0), run({})).events());
  // An event at 6 s, after the end of the other run, is no difference; it is one if both could have it.
  const auto shorter = compare(sat, run({.speed = 0.2}, 1.0, 4.0, 1.0), run({.speed = 0.2}, 1.0, 11.0, 1.0));
  ASSERT_TRUE(shorter.events());
  EXPECT_EQ(shorter.events()->size, 0.0 * s);
  EXPECT_FALSE(compare(sat, run({.speed = 0.2}, 1.0, 8.0, 1.0), run({}, 1.0, 11.0)).events());
}

/// The arm, which moves along the hub, is locked where its coordinate passes `at`: an impulse stops it.
CraftTrajectory<Sat, Locked<Arm>> latched(double arm_speed, double at, double end = 11.0) {
  const Sat sat;
  const auto none = 0.0 * rad_s;
  const auto still = angular_velocity(of<Hub>, relative_to<Gcrf>, vector(in<Hub>, none, none, none));
  const MovingTransform<Gcrf, Hub> hub{{aligned(to<Gcrf>, from<Hub>), still},
                                       coincident(of<Hub>, relative_to<Gcrf>, in<Gcrf>),
                                       velocity(of<Hub>, relative_to<Gcrf>, observed_from<Gcrf>,
                                                vector(in<Gcrf>, 0.0 * m_s, 0.0 * m_s, 0.0 * m_s))};
  const MovingTransform<Hub, Probe> probe{
      {aligned(to<Hub>, from<Probe>),
       angular_velocity(of<Probe>, relative_to<Hub>, vector(in<Probe>, none, none, none))},
      coincident(of<Probe>, relative_to<Hub>, in<Hub>),
      velocity(of<Probe>, relative_to<Hub>, observed_from<Hub>,
               vector(in<Hub>, 0.0 * m_s, 0.0 * m_s, 0.0 * m_s))};
  const auto latch = when(
      "latch", [at](const Now<Sat>& now) { return now.coordinate(of<Arm>) - at * m; }, ode::Direction::rising,
      becomes(Locked<Arm>{true}));
  return propagate(scenario(sat, lockable(sat, of<Arm>), latch),
                   state(sat, 1.0 * s, hub, starts(of<Arm>, 0.0 * m, arm_speed * m_s), starts(probe),
                         spins(of<Wheel>, none)),
                   {.end = end * s,
                    .relative_tolerance = 1e-12,
                    .absolute_tolerances = {1e-12 * rad, 1e-12 * rad_s, 1e-12 * m, 1e-12 * m_s, 1e-12}});
}

// Between the two impulses one run has stopped and the other has not: that is no difference of the mechanics.
TEST(Comparison, compares_each_impulse_at_its_own_time) {
  const Sat sat;
  const double at = 0.5, later = at + 1e-9, speed = 0.25;  // after 2 s, and 4 ns later
  const auto found = compare(sat, latched(speed, at), latched(speed, later));
  EXPECT_NEAR(found.speed(of<Arm>).size.in(m_s), 0.0, rounding);
  EXPECT_NEAR(found.velocity(of<Hub>).size.in(m_s), 0.0, rounding);
  EXPECT_NEAR(found.coordinate(of<Arm>).size.in(m), later - at, rounding);
  ASSERT_TRUE(found.impulses());
  EXPECT_NEAR(found.impulses()->size.in(s), (later - at) / speed, rounding);
  EXPECT_NEAR(found.impulses()->time.in(s), 1.0 + at / speed, rounding);
  std::ostringstream out;
  out << found;
  EXPECT_NE(out.str().find("times of impulses  4.0e-09 s"), std::string::npos) << out.str();
}

// Other speeds at the impulse are seen, before it and after it.
TEST(Comparison, sees_what_an_impulse_changes) {
  const Sat sat;
  const auto found = compare(sat, latched(0.25, 0.5), latched(0.26, 0.52));  // both after 2 s
  EXPECT_NEAR(found.speed(of<Arm>).size.in(m_s), 0.01, rounding);
  // The arm of 1 kg shares its momentum with the hub of 10 kg; the probe is on a free joint.
  EXPECT_NEAR(found.momentum().size.value(), 0.01, rounding);
  EXPECT_NEAR(found.velocity(of<Hub>).size.in(m_s), 0.01 / 11.0, rounding);
}

TEST(Comparison, says_that_one_run_has_an_impulse_and_the_other_none) {
  const Sat sat;
  const auto found = compare(sat, latched(0.25, 0.5), latched(0.25, 50.0));
  EXPECT_FALSE(found.impulses());
  EXPECT_NEAR(found.speed(of<Arm>).size.in(m_s), 0.25, rounding);
  std::ostringstream out;
  out << found;
  EXPECT_NE(out.str().find("the impulses differ: 1 and 0\n"), std::string::npos) << out.str();
  // One after the end of the other run is no difference.
  ASSERT_TRUE(compare(sat, latched(0.25, 0.5, 2.0), latched(0.25, 0.5)).impulses());
}

TEST(Comparison, prints_a_row_for_each_quantity) {
  std::ostringstream out;
  out << compare(Sat{}, run({}), run({.place = 0.1, .wheel = 5.0})) << std::setw(4) << 7 << '\n';
  EXPECT_EQ(out.str(),
            "1 to 11 s          largest difference    at\n"
            "attitude of Hub    0.0e+00 rad           1 s\n"
            "rate of Hub        0.0e+00 rad/s         1 s\n"
            "position of Hub    1.0e-01 m             1 s\n"
            "velocity of Hub    0.0e+00 m/s           1 s\n"
            "coordinate of Arm  0.0e+00 m             1 s\n"
            "attitude of Probe  0.0e+00 rad           1 s\n"
            "position of Probe  0.0e+00 m             1 s\n"
            "speed of Arm       0.0e+00 m/s           1 s\n"
            "rate of Probe      0.0e+00 rad/s         1 s\n"
            "velocity of Probe  0.0e+00 m/s           1 s\n"
            "spin of Wheel      5.0e+00 rad/s         1 s\n"
            "energy             1.2e+00 J             1 s\n"
            "momentum           0.0e+00 kg m/s        1 s\n"
            "angular momentum   5.0e-01 N m s         1 s\n"
            "   7\n");  // as before
}

}  // namespace
}  // namespace vectrix_test::comparison_test
