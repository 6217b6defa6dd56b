#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vectrix/dynamics/analysis/linearise.hpp>
#include <vectrix/dynamics/load/lockable.hpp>
#include <vectrix/dynamics/load/prescribed.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "load/sine.hpp"
#include "load/three_parts.hpp"

// Joints whose motion is a given function of time.
namespace vectrix_test::three_parts::prescribed_test {
namespace {

using namespace vectrix;
using namespace short_units;

constexpr double tolerance = 1e-13;
constexpr auto rad_s2 = rad_s / s;
constexpr auto m_s2 = m_s / s;

const Sat sat;
constexpr Sine scan{0.4, 3.0};
constexpr double w_0 = 0.2, J_panel_at_hub = J_rest + J_panel;

Starting start_of_scan() {
  return {.angle = scan.q(0.0), .rate = scan.u(0.0), .spin = 5.0, .hub_rate = w_0};
}
/// A step changes each number by tolerance (1 + |y|) at most; numbers are below ten, steps below a hundred.
constexpr double run_error = 1e3 * tolerance;

// (J_h + J_p) w + J_p q' is kept, and the wheel keeps its own: so w and the torque of the drive are known.
TEST(Prescribed, APanelInThePlaneTurnsTheHubBack) {
  const auto flight = scenario(sat, prescribed(sat, of<Panel>, turning(scan)));
  const auto run = propagate(flight, start_of(sat, start_of_scan()), until(7.0, tolerance));
  for (const double t : {0.0, 0.3, 1.7, 4.0, 7.0}) {
    const auto now = motion_at(flight, run, t * s);
    const double back = J_panel / J_panel_at_hub;
    EXPECT_NEAR(now.state().coordinate(of<Panel>).value(), scan.q(t), run_error) << t;
    EXPECT_NEAR(now.state().speed(of<Panel>).value(), scan.u(t), run_error) << t;
    const double w = now.now().angular_velocity(of<Hub>, relative_to<Inertial>, in<Hub>).z().value();
    EXPECT_NEAR(w, w_0 - back * (scan.u(t) - scan.u(0.0)), run_error) << t;
    const double turned = w_0 * t - back * (scan.q(t) - scan.q(0.0) - scan.u(0.0) * t);
    const auto R = now.now().rotation(to<Inertial>, from<Hub>).matrix();
    EXPECT_NEAR(std::remainder(std::atan2(R(1, 0), R(0, 0)) - turned, 2.0 * std::numbers::pi), 0.0, run_error)
        << t;
    EXPECT_NEAR(now.holding_effort(of<Panel>).value(), J_panel * J_rest / J_panel_at_hub * scan.a(t),
                run_error)
        << t;
  }
}

TEST(Prescribed, ASpringOnTheJointChangesTheDriveOnly) {
  const auto k = 2.0 * N_m / rad;
  const auto c = 0.3 * N_m / rad_s;
  const auto start = start_of(sat, {.time = 0.4, .angle = scan.q(0.4), .rate = scan.u(0.4), .hub_rate = w_0});
  const auto drive = prescribed(sat, of<Panel>, turning(scan));
  const auto alone = motion(sat, start, drive);
  const auto sprung =
      motion(sat, start, spring(sat, of<Panel>, k, 0.0 * rad), drive, damper(sat, of<Panel>, c));
  EXPECT_EQ(sprung.rates(), alone.rates());
  const auto added = sprung.holding_effort(of<Panel>) - alone.holding_effort(of<Panel>);
  EXPECT_NEAR(added.value(), 2.0 * scan.q(0.4) + 0.3 * scan.u(0.4), 1e-15);
}

// A mass m on a rail: the hub goes back, and the drive gives the force on both.
TEST(Prescribed, AMassOnItsRailPushesTheHub) {
  constexpr double all = m_hub + m_panel + m_mass;
  const Sine to_and_fro{0.5, 2.0};
  const auto flight = scenario(sat, prescribed(sat, of<Mass>, [&](const Quantity<si::time>& t) {
                                 return to_and_fro.sliding(t.value());
                               }));
  const auto run = propagate(flight, start_of(sat, {.velocity = to_and_fro.u(0.0)}), until(4.0, tolerance));
  const auto now = motion_at(flight, run, 4.0 * s);
  EXPECT_NEAR(now.holding_effort(of<Mass>).value(), m_mass * (all - m_mass) / all * to_and_fro.a(4.0),
              run_error);
  EXPECT_NEAR(run.at(4.0 * s).hub_motion().velocity.coordinates().x(),
              -m_mass / all * (to_and_fro.u(4.0) - to_and_fro.u(0.0)), run_error);
}

template <class F> std::string refusal(const F& f, const Starting& with, double end = 7.0) {
  const auto run = [&] {
    (void)propagate(scenario(sat, prescribed(sat, of<Panel>, f)), start_of(sat, with), until(end));
  };
  return message<BadInput>(run);
}

TEST(Prescribed, AStartThatDisagreesIsRefused) {
  EXPECT_EQ(refusal(turning(scan), {.angle = 0.01, .rate = scan.u(0.0)}),
            "prescribed on vectrix_test::three_parts::Panel at 0 s: the coordinate is 0 rad, but the run "
            "starts with 0.01 rad");
  EXPECT_EQ(refusal(turning(scan), {.time = 1.0, .angle = scan.q(1.0), .rate = -scan.u(1.0)}),
            "prescribed on vectrix_test::three_parts::Panel at 1 s: the speed is " +
                detail::text(scan.u(1.0)) + " rad/s, but the run starts with " + detail::text(-scan.u(1.0)) +
                " rad/s");
}

TEST(Prescribed, AnEmptyFunctionIsRefused) {
  const std::function<decltype(scan.turning(0.0))(const Quantity<si::time>&)> empty;
  EXPECT_EQ(message<BadInput>([&] { (void)prescribed(sat, of<Panel>, empty); }),
            "prescribed on vectrix_test::three_parts::Panel: the function is empty");
}

TEST(Prescribed, AWrongDerivativeIsRefused) {
  const auto with = [](double of_speed, double of_acceleration) {
    return [=](const Quantity<si::time>& t) {
      auto given = scan.turning(t.value());
      given.speed = of_speed * given.speed;
      given.acceleration = of_acceleration * given.acceleration;
      return given;
    };
  };
  const auto start = [](double of_speed) {
    return Starting{.angle = scan.q(0.0), .rate = of_speed * scan.u(0.0)};
  };
  EXPECT_TRUE(contains(refusal(with(1.001, 1.001), start(1.001)), "rad/s, but the coordinate changes by "));
  EXPECT_TRUE(contains(refusal(with(1.0, -1.0), start(1.0)), "rad/s^2, but the speed changes by "));
  EXPECT_TRUE(contains(refusal(with(1.0, 1.0001), start(1.0)), "rad/s^2, but the speed changes by "));
  EXPECT_TRUE(contains(refusal(with(NAN, 1.0), start(1.0)), "the speed is nan"));
}

TEST(Prescribed, ALockedJointIsNotDriven) {
  const auto lock = [](const Now<Sat>&, Forces<Sat>& forces) { forces.lock(of<Panel>); };
  const auto drive = prescribed(sat, of<Panel>, turning(scan));
  const auto start = start_of(sat, start_of_scan());
  const std::string said =
      "the joint of vectrix_test::three_parts::Panel is driven, and locked or driven again";
  EXPECT_EQ(message<BadInput>([&] { (void)motion(sat, start, lock, drive); }), said);
  EXPECT_EQ(message<BadInput>([&] { (void)motion(sat, start, drive, lock); }), said);
  EXPECT_EQ(message<BadInput>([&] { (void)motion(sat, start, drive, drive); }), said);
  EXPECT_NO_THROW((void)motion(sat, start, lock, lock));
}

/// The speed of a wheel.
auto spinning(const Sine& sine) {
  return [sine](const Quantity<si::time>& t) {
    return RotorMotion{sine.q(t.value()) * rad_s, sine.u(t.value()) * rad_s2};
  };
}
constexpr Sine throttle{4.0, 1.5, 20.0};
Starting start_of_throttle() {
  return {.rate = 0.3, .spin = throttle.q(0.0), .hub_rate = w_0};
}

// J w + J_s O is kept, and the panel keeps its own: so w and the torque of the drive are known.
TEST(Prescribed, AWheelTurnsTheHubBack) {
  const auto flight = scenario(sat, prescribed(sat, of<Wheel>, spinning(throttle)));
  const auto run = propagate(flight, start_of(sat, start_of_throttle()), until(7.0, tolerance));
  constexpr double J = J_rest + J_wheel;
  for (const double t : {0.0, 0.3, 1.7, 4.0, 7.0}) {
    const auto now = motion_at(flight, run, t * s);
    EXPECT_NEAR(now.state().spin(of<Wheel>).value(), throttle.q(t), run_error) << t;
    EXPECT_NEAR(now.now().angular_velocity(of<Hub>, relative_to<Inertial>, in<Hub>).z().value(),
                w_0 - J_wheel / J * (throttle.q(t) - throttle.q(0.0)), run_error)
        << t;
    EXPECT_NEAR(now.holding_effort(of<Wheel>).value(), J_wheel * J_rest / J * throttle.u(t), run_error) << t;
  }
}

TEST(Prescribed, AMotorOnTheWheelChangesItsDriveOnly) {
  const auto start = start_of(sat, start_of_throttle());
  const auto drive = prescribed(sat, of<Wheel>, spinning(throttle));
  const auto drag = [](const Now<Sat>& now, Forces<Sat>& forces) {
    forces.motor(of<Wheel>, -0.01 * now.spin(of<Wheel>).value() * N_m);
  };
  const auto alone = motion(sat, start, drive), braked = motion(sat, start, drag, drive);
  EXPECT_EQ(braked.rates(), alone.rates());
  EXPECT_NEAR((braked.holding_effort(of<Wheel>) - alone.holding_effort(of<Wheel>)).value(),
              0.01 * throttle.q(0.0), 1e-15);
  EXPECT_EQ(motion(sat, start, drag).holding_effort(of<Wheel>).value(), 0.0);
}

TEST(Prescribed, AWheelThatDisagreesIsRefused) {
  const auto refused = [](const auto& f, double spin) {
    return message<BadInput>([&] {
      (void)propagate(scenario(sat, prescribed(sat, of<Wheel>, f)), start_of(sat, {.spin = spin}),
                      until(7.0));
    });
  };
  EXPECT_EQ(
      refused(spinning(throttle), 19.0),
      "prescribed on vectrix_test::three_parts::Wheel at 0 s: the speed is 20 rad/s, but the run starts "
      "with 19 rad/s");
  const auto wrong = [](const Quantity<si::time>& t) {
    return RotorMotion{throttle.q(t.value()) * rad_s, 1.001 * throttle.u(t.value()) * rad_s2};
  };
  EXPECT_TRUE(contains(refused(wrong, 20.0), "rad/s^2, but the speed changes by "));
  const auto start = start_of(sat, start_of_throttle());
  const auto drive = prescribed(sat, of<Wheel>, spinning(throttle));
  const auto lock = [](const Now<Sat>&, Forces<Sat>& forces) { forces.lock(of<Wheel>); };
  EXPECT_EQ(message<BadInput>([&] { (void)motion(sat, start, drive, lock); }),
            "the rotor vectrix_test::three_parts::Wheel is driven, and locked or driven again");
}

// A latch of the panel stops it by an impulse, in which the wheel keeps its given speed.
TEST(Prescribed, AWheelKeepsItsSpeedInAnImpulse) {
  const auto flight = scenario(sat, prescribed(sat, of<Wheel>, spinning(throttle)), lockable(sat, of<Panel>),
                               at_times({1.0 * s}, becomes(Locked<Panel>{true})));
  const auto run = propagate(flight, start_of(sat, start_of_throttle()), until(3.0, tolerance));
  EXPECT_EQ(run.at(3.0 * s).speed(of<Panel>).value(), 0.0);
  EXPECT_NEAR(run.at(3.0 * s).spin(of<Wheel>).value(), throttle.q(3.0), run_error);
}

// A held joint is no freedom of the linear system: its acceleration depends on nothing.
TEST(Prescribed, AMotionIsLinearisedAboutIt) {
  const auto still = [](const Quantity<si::time>&) {
    return JointMotion{0.3 * rad, 0.0 * rad_s, 0.0 * rad_s2};
  };
  const auto flight =
      scenario(sat, prescribed(sat, of<Panel>, still), spring(sat, of<Panel>, 2.0 * N_m / rad, 0.0 * rad));
  const auto linear = linearise(flight, start_of(sat, {.angle = 0.3, .hub_rate = w_0}));
  EXPECT_EQ(linear.A.row(linear.speed(of<Panel>)).norm(), 0.0);
  EXPECT_GT(linear.A.row(linear.speed(of<Mass>)).norm(), 0.0);
  const auto steady = [](const Quantity<si::time>&) { return RotorMotion{5.0 * rad_s, 0.0 * rad_s2}; };
  const auto spinning = linearise(scenario(sat, prescribed(sat, of<Wheel>, steady)),
                                  start_of(sat, {.spin = 5.0, .hub_rate = w_0}));
  EXPECT_EQ(spinning.A.row(spinning.spin(of<Wheel>)).norm(), 0.0);
}

// The check of a function knows neither its time scale nor that of the run.
TEST(Prescribed, ASmoothFunctionIsNotRefused) {
  for (const double epoch : {0.0, -3.0, 1e4, 8e8})
    for (const double span : {1e-2, 1.0, 1e3, 1e6})
      for (const double rate : {1e-5, 1e-2, 1.0, 6.283185307179586, 1e3}) {
        const Sine sine{0.7, rate, 0.2, epoch};
        const auto numbers = [&](double off) {
          return [&sine, off](double t) {
            return detail::JointNumbers{sine.q(t), sine.u(t), off * sine.a(t)};
          };
        };
        const auto require = [&](double off) {
          detail::require_motion({"it", "rad", "rad/s", "rad/s^2", numbers(off)}, epoch, epoch + span,
                                 sine.q(epoch), sine.u(epoch));
        };
        EXPECT_NO_THROW(require(1.0)) << epoch << ' ' << span << ' ' << rate;
        // Where the digits of time resolve the motion.
        if (std::abs(epoch) < 1e5 && rate * span > 1e-3) {
          EXPECT_THROW(require(1.01), BadInput) << epoch << ' ' << span << ' ' << rate;
        }
      }
}

}  // namespace
}  // namespace vectrix_test::three_parts::prescribed_test
