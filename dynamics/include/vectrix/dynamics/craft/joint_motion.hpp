#pragma once

#include <array>
#include <cstddef>
#include <vectrix/dynamics/craft/craft_numbers.hpp>

namespace vectrix {

/// Where a joint with one axis is at an instant, with its speed and its acceleration: rad, rad/s, rad/s^2 of
/// what turns; m, m/s, m/s^2 of a slider.
template <class Q, class U, class A> struct JointMotion {
  Quantity<Q> coordinate;
  Quantity<U> speed;
  Quantity<A> acceleration;
};
template <class Q, class U, class A>
JointMotion(const Quantity<Q>&, const Quantity<U>&, const Quantity<A>&) -> JointMotion<Q, U, A>;

namespace detail {
template <class... Given> struct NotThree {};
}  // namespace detail
template <class... Given> struct JointMotion<detail::NotThree<Given...>, void, void> {
  JointMotion(const Given&...) = delete;  // {q, u, a}, each with its unit: rad, rad/s, rad/s^2; m, m/s, m/s^2
};
template <class... Given> JointMotion(const Given&...) -> JointMotion<detail::NotThree<Given...>, void, void>;

/// The speed of a rotor relative to its body at an instant, and its rate.
struct RotorMotion {
  Quantity<si::angular_velocity> speed;
  Quantity<si::angular_acceleration> acceleration;

  RotorMotion(const Quantity<si::angular_velocity>& speed_given,
              const Quantity<si::angular_acceleration>& acceleration_given)
      : speed(speed_given), acceleration(acceleration_given) {}
  template <class... Given>
  RotorMotion(const Given&...) = delete;  // {speed, acceleration}, each with its unit: rad/s, rad/s^2
};

namespace detail {

/// One of a hinge or slider; two of a gimbal.
template <JointKind kind> struct MotionOfJoint {
  using Units = JointUnits<kind>;
  using type = JointMotion<typename Units::coordinate, typename Units::speed, typename Units::acceleration>;
};
template <> struct MotionOfJoint<JointKind::gimbal> {
  using type = std::array<typename MotionOfJoint<JointKind::hinge>::type, 2>;
};

/// In plain numbers, by axis; of a rotor there is no coordinate.
using JointNumbers = std::array<double, 3>;
template <class Q, class U, class A>
std::array<JointNumbers, 1> numbers_of(const JointMotion<Q, U, A>& motion) {
  return {{{motion.coordinate.value(), motion.speed.value(), motion.acceleration.value()}}};
}
inline std::array<JointNumbers, 1> numbers_of(const RotorMotion& motion) {
  return {{{0.0, motion.speed.value(), motion.acceleration.value()}}};
}
template <class Motion> std::array<JointNumbers, 2> numbers_of(const std::array<Motion, 2>& motions) {
  return {numbers_of(motions[0])[0], numbers_of(motions[1])[0]};
}

}  // namespace detail
}  // namespace vectrix
