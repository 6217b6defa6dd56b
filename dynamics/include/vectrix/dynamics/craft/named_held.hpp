#pragma once

#include <array>
#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/given_function.hpp>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/craft/prescribing.hpp>
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

/// The kind of the joint that has such an acceleration, or such two.
template <class Given> inline constexpr auto joint_of_acceleration = std::optional<JointKind>{};
template <>
inline constexpr auto joint_of_acceleration<Quantity<si::angular_acceleration>> =
    std::optional{JointKind::hinge};
template <>
inline constexpr auto joint_of_acceleration<Quantity<si::acceleration>> = std::optional{JointKind::slider};
template <>
inline constexpr auto joint_of_acceleration<std::array<Quantity<si::angular_acceleration>, 2>> =
    std::optional{JointKind::gimbal};

template <class U> std::array<double, 2> acceleration_numbers(const Quantity<U>& a) {
  return {a.value(), 0.0};
}
template <class U> std::array<double, 2> acceleration_numbers(const std::array<Quantity<U>, 2>& a) {
  return {a[0].value(), a[1].value()};
}
template <class F>
NamedHeld prescribed_by_name(const std::string& body, JointKind joint, const F& acceleration, int axis = 0) {
  require_function([&] { return "prescribed(\"" + body + "\")"; }, acceleration);
  return {trusted, body, joint,
          [acceleration](double t) { return acceleration_numbers(acceleration(t * si::second)); }, axis};
}

/// prescribed("name", f): a hinge, a rotor, a slider, or both axes of a gimbal, with the given acceleration,
/// which must be smooth between the breakpoints of the run and at them: it is not told on which side of one
/// it is asked. Throws BadInput for an empty std::function.
template <class Name, class F>
  requires std::convertible_to<const Name&, std::string>
struct Prescribed<Name, F> {
  static constexpr bool fits = true;
  static auto make(const Name& body, const F& acceleration) {
    constexpr auto joint = joint_of_acceleration<typename GivenMotion<F>::type>;
    static_assert(
        joint || has_error<F, const Quantity<si::time>&>(),
        "prescribed(\"name\", f): f(t) gives an acceleration, rad/s^2 of a hinge or rotor, m/s^2 of a "
        "slider, a std::array of two of a gimbal");
    if constexpr (joint)
      return prescribed_by_name(body, *joint, acceleration);
    else
      return Refused{};
  }
};
/// A gimbal about one axis, 1 or 2; about the other it is free.
template <class Name, class F>
  requires std::convertible_to<const Name&, std::string>
struct Prescribed<Name, int, F> {
  static constexpr bool fits = true;
  static auto make(const Name& body, int axis, const F& acceleration) {
    constexpr bool turns = joint_of_acceleration<typename GivenMotion<F>::type> == JointKind::hinge;
    static_assert(turns || has_error<F, const Quantity<si::time>&>(),
                  "prescribed(\"name\", axis, f): f(t) gives the acceleration about this axis, rad/s^2");
    if constexpr (turns)
      return prescribed_by_name(body, JointKind::gimbal, acceleration, axis);
    else
      return Refused{};
  }
};

}  // namespace detail

}  // namespace vectrix
