// Prescribed motion
#include <cmath>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

#include "panelled_sat.hpp"

constexpr auto rad = si::radian;
constexpr auto s = si::second;

namespace a_scan_in_degrees {
// mistake: the speed of a hinge that is scanned in deg/s
// expect: JointMotion<(vectrix::)?si::angle, (vectrix::)?si::degree_per_second_unit
// expect: f: JointMotion\{rad, rad/s, rad/s\^2\}
auto scan(const Sat& sat) {
#ifdef REPAIRED
  const auto rate = 1.0 * rad / s;
#else
  const auto rate = 57.3 * si::degree_per_second;
#endif
  const auto turning = [=](const Quantity<si::time>& t) {
    return JointMotion{t.in(s)*rad, rate, 0.0 * rad / s / s};
  };
  return prescribed(sat, of<Panel>, turning);
}
}  // namespace a_scan_in_degrees

namespace a_scan_in_metres {
// mistake: the speed of a hinge that is scanned in m/s
// expect: JointMotion<(vectrix::)?si::angle, (vectrix::)?si::velocity
// expect: f: JointMotion\{rad, rad/s, rad/s\^2\}
auto scan(const Sat& sat) {
#ifdef REPAIRED
  const auto rate = 1.0 * rad / s;
#else
  const auto rate = 1.0 * si::metre / s;
#endif
  const auto turning = [=](const Quantity<si::time>& t) {
    return JointMotion{t.in(s)*rad, rate, 0.0 * rad / s / s};
  };
  return prescribed(sat, of<Panel>, turning);
}
}  // namespace a_scan_in_metres

namespace a_scan_without_units {
// mistake: the angle of a scan as a bare number
// expect: each with its unit: rad, rad/s, rad/s\^2
auto scan(const Quantity<si::time>& t) {
#ifdef REPAIRED
  return JointMotion{t.in(s)*rad, 1.0 * rad / s, 0.0 * rad / s / s};
#else
  return JointMotion{t.in(s), 1.0 * rad / s, 0.0 * rad / s / s};
#endif
}
}  // namespace a_scan_without_units

namespace a_speed_of_a_wheel_that_is_a_unit {
// mistake: a unit where the acceleration of a wheel is due
// expect: \{speed, acceleration\}, each with its unit: rad/s, rad/s\^2
auto throttle(const Quantity<si::time>&) {
#ifdef REPAIRED
  return RotorMotion{30.0 * rad / s, 1.0 * rad / s / s};
#else
  return RotorMotion{30.0 * rad / s, rad / s / s};
#endif
}
}  // namespace a_speed_of_a_wheel_that_is_a_unit

namespace a_scan_of_what_hangs_nowhere {
// mistake: the motion of a joint of the hub, which hangs on nothing
// expect: Of<(.*::)?Hub>
// expect: f: JointMotion
auto scan(const Sat& sat) {
  const auto still = [](const Quantity<si::time>&) {
    return JointMotion{0.1 * rad, 0.0 * rad / s, 0.0 * rad / s / s};
  };
#ifdef REPAIRED
  return prescribed(sat, of<Panel>, still);
#else
  return prescribed(sat, of<Hub>, still);
#endif
}
}  // namespace a_scan_of_what_hangs_nowhere

namespace a_drive_by_a_torque {
// mistake: a torque where the acceleration of a hinge is due
// expect: rad/s\^2 of a hinge
void drive(Forces<Sat>& forces) {
#ifdef REPAIRED
  forces.drive(of<Panel>, 0.1 * rad / s / s);
#else
  forces.drive(of<Panel>, 0.1 * si::newton_metre);
#endif
}
}  // namespace a_drive_by_a_torque

namespace a_wheel_with_the_motion_of_a_joint {
// mistake: an angle for a wheel, whose state is its speed alone
// expect: rotor: RotorMotion
auto throttle(const Sat& sat) {
  const auto steady = [](const Quantity<si::time>&) {
#ifdef REPAIRED
    return RotorMotion{30.0 * rad / s, 0.0 * rad / s / s};
#else
    return JointMotion{0.1 * rad, 30.0 * rad / s, 0.0 * rad / s / s};
#endif
  };
  return prescribed(sat, of<Wheel>, steady);
}
}  // namespace a_wheel_with_the_motion_of_a_joint

namespace an_axis_of_a_hinge {
// mistake: the motion about one axis of a gimbal, on a hinge
// expect: AboutAxis<1>
// expect: two of a gimbal
auto scan(const Sat& sat) {
  const auto still = [](const Quantity<si::time>&) {
    return JointMotion{0.1 * rad, 0.0 * rad / s, 0.0 * rad / s / s};
  };
#ifdef REPAIRED
  return prescribed(sat, of<Panel>, still);
#else
  return prescribed(sat, of<Panel>, about_axis<1>, still);
#endif
}
}  // namespace an_axis_of_a_hinge

namespace a_scan_without_its_craft {
// mistake: the craft of a motion is left out
// expect: craft, of<B>, f: JointMotion
auto scan(const Sat& sat) {
  const auto still = [](const Quantity<si::time>&) {
    return JointMotion{0.1 * rad, 0.0 * rad / s, 0.0 * rad / s / s};
  };
#ifdef REPAIRED
  return prescribed(sat, of<Panel>, still);
#else
  return static_cast<void>(sat), prescribed(of<Panel>, still);
#endif
}
}  // namespace a_scan_without_its_craft

namespace an_angle_as_a_motion {
// mistake: the angle of a hinge alone, without its speed and its acceleration
// expect: Result = (vectrix::)?Quantity<(vectrix::)?si::angle
// expect: f: JointMotion\{rad, rad/s, rad/s\^2\}
auto scan(const Sat& sat) {
  const auto turning = [](const Quantity<si::time>& t) {
#ifdef REPAIRED
    return JointMotion{t.in(s)*rad, 1.0 * rad / s, 0.0 * rad / s / s};
#else
    return t.in(s)*rad;
#endif
  };
  return prescribed(sat, of<Panel>, turning);
}
}  // namespace an_angle_as_a_motion

namespace a_motion_without_its_acceleration {
// mistake: angle and speed of a hinge, without its acceleration: one error, though the function has no result
// expect: \{q, u, a\}, each with its unit
auto scan(const Sat& sat) {
  const auto turning = [](const Quantity<si::time>& t) {
#ifdef REPAIRED
    return JointMotion{t.in(s)*rad, 1.0 * rad / s, 0.0 * rad / s / s};
#else
    return JointMotion{t.in(s)*rad, 1.0 * rad / s};
#endif
  };
  return scenario(sat, prescribed(sat, of<Panel>, turning));
}
}  // namespace a_motion_without_its_acceleration

namespace an_angle_of_a_named_joint {
// mistake: the angle of a joint with a name, where its acceleration is due
// expect: gives an acceleration, rad/s\^2 of a hinge or rotor, m/s\^2 of a slider
auto scan() {
#ifdef REPAIRED
  return prescribed("panel", [](const Quantity<si::time>& t) { return -std::sin(t.in(s)) * rad / s / s; });
#else
  return prescribed("panel", [](const Quantity<si::time>& t) { return std::sin(t.in(s)) * rad; });
#endif
}
}  // namespace an_angle_of_a_named_joint

namespace a_named_motion_of_a_number {
// mistake: the acceleration of a joint with a name as a function of a bare number
// expect: f\(t\) gives an acceleration
auto scan() {
#ifdef REPAIRED
  return prescribed("panel", [](const Quantity<si::time>& t) { return -std::sin(t.in(s)) * rad / s / s; });
#else
  return prescribed("panel", [](double t) { return -std::sin(t); });
#endif
}
}  // namespace a_named_motion_of_a_number
