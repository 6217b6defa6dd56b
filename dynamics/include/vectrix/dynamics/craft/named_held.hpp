#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// A joint whose motion is given: its acceleration, a function of time. Its position and speed stay in the
/// state and follow from their start. Made by locked() and prescribed().
class NamedHeld {
 public:
  NamedHeld(detail::Trusted, std::string body, std::optional<JointKind> joint,
            std::function<double(double)> acceleration)
      : body_(std::move(body)), joint_(joint), acceleration_(std::move(acceleration)) {}

  const std::string& body() const { return body_; }
  /// The kind that the joint must have; none if any is held.
  const std::optional<JointKind>& joint() const { return joint_; }
  /// At the time t, s, in rad/s^2 or m/s^2.
  double acceleration(double t) const { return acceleration_(t); }

 private:
  std::string body_;
  std::optional<JointKind> joint_;
  std::function<double(double)> acceleration_;
};

/// The joint of a body keeps its speed: a joint that starts at rest stays where it is.
inline NamedHeld locked(std::string body) {
  return {detail::trusted, std::move(body), std::nullopt, [](double) { return 0.0; }};
}
/// A hinge, or a slider, with the given acceleration, which must be smooth between the breakpoints of the run
/// and at them: it is not told on which side of one it is asked.
inline NamedHeld prescribed(
    std::string body,
    std::function<Quantity<si::angular_acceleration>(const Quantity<si::time>&)> acceleration) {
  return {detail::trusted, std::move(body), JointKind::hinge,
          [given = std::move(acceleration)](double t) { return given(t * si::second).value(); }};
}
inline NamedHeld prescribed(
    std::string body, std::function<Quantity<si::acceleration>(const Quantity<si::time>&)> acceleration) {
  return {detail::trusted, std::move(body), JointKind::slider,
          [given = std::move(acceleration)](double t) { return given(t * si::second).value(); }};
}

}  // namespace vectrix
