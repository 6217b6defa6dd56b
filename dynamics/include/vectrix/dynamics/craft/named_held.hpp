#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vectrix/dynamics/craft/given_function.hpp>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// A joint or a rotor whose motion is given: its accelerations, rad/s^2 or m/s^2 by axis, a function of time.
/// Its positions and speeds stay in the state and follow from their start. Made by locked() and prescribed().
class NamedHeld {
 public:
  using Accelerations = std::function<std::array<double, 2>(double t)>;
  NamedHeld(detail::Trusted, std::string name, std::optional<JointKind> joint, Accelerations accelerations,
            int axis = 0)
      : name_(std::move(name)), joint_(joint), accelerations_(std::move(accelerations)), axis_(axis) {}

  /// Of the body that hangs on the joint, or of the rotor.
  const std::string& name() const { return name_; }
  /// The kind that the joint must have; none if it is locked, as any may be.
  const std::optional<JointKind>& joint() const { return joint_; }
  /// At the time t, s; of a gimbal two, else the first. Of a locked joint there is no function.
  const Accelerations& accelerations() const { return accelerations_; }
  /// 1 or 2 of a gimbal that is held about one axis; else 0.
  int axis() const { return axis_; }

 private:
  std::string name_;
  std::optional<JointKind> joint_;
  Accelerations accelerations_;
  int axis_;
};

/// The joint of a body, or a rotor, keeps its speed: a joint that starts at rest stays where it is.
inline NamedHeld locked(std::string name) {
  return {detail::trusted, std::move(name), std::nullopt, {}};
}

namespace detail {

template <class F> F given_acceleration(const std::string& body, F acceleration) {
  return given_function([&] { return "prescribed(\"" + body + "\")"; }, std::move(acceleration));
}

}  // namespace detail

/// A hinge, a rotor, a slider, or both axes of a gimbal, with the given acceleration, which must be smooth
/// between the breakpoints of the run and at them: it is not told on which side of one it is asked. Throws
/// BadInput for an empty std::function.
inline NamedHeld prescribed(
    const std::string& body,
    std::function<Quantity<si::angular_acceleration>(const Quantity<si::time>&)> acceleration) {
  return {detail::trusted, body, JointKind::hinge,
          [given = detail::given_acceleration(body, std::move(acceleration))](double t) {
            return std::array{given(t * si::second).value(), 0.0};
          }};
}
inline NamedHeld prescribed(
    const std::string& body,
    std::function<Quantity<si::acceleration>(const Quantity<si::time>&)> acceleration) {
  return {detail::trusted, body, JointKind::slider,
          [given = detail::given_acceleration(body, std::move(acceleration))](double t) {
            return std::array{given(t * si::second).value(), 0.0};
          }};
}
inline NamedHeld prescribed(
    const std::string& body,
    std::function<std::array<Quantity<si::angular_acceleration>, 2>(const Quantity<si::time>&)>
        accelerations) {
  return {detail::trusted, body, JointKind::gimbal,
          [given = detail::given_acceleration(body, std::move(accelerations))](double t) {
            const auto both = given(t * si::second);
            return std::array{both[0].value(), both[1].value()};
          }};
}

/// A gimbal about one axis, 1 or 2; about the other it is free.
inline NamedHeld prescribed(
    const std::string& body, int axis,
    std::function<Quantity<si::angular_acceleration>(const Quantity<si::time>&)> acceleration) {
  return {detail::trusted, body, JointKind::gimbal,
          [given = detail::given_acceleration(body, std::move(acceleration))](double t) {
            return std::array{given(t * si::second).value(), 0.0};
          },
          axis};
}

}  // namespace vectrix
