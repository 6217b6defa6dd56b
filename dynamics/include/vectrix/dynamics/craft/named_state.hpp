#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/craft/starting.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/named/transform.hpp>

namespace vectrix {
namespace detail {
class NamedCraftCore;
}  // namespace detail

/// The start of a joint, a rotor or a mode, by its name; a joint has the name of the body that hangs on it.
class VECTRIX_EXPORT NamedStart {
 public:
  struct Rotor {};
  struct Mode {};
  using Of = std::variant<JointKind, Rotor, Mode>;
  NamedStart(detail::Trusted, std::string name, Of of, std::vector<double> positions,
             std::vector<double> speeds, std::string relative_to = {})
      : name_(std::move(name)),
        relative_to_(std::move(relative_to)),
        of_(of),
        positions_(std::move(positions)),
        speeds_(std::move(speeds)) {}

  const std::string& name() const { return name_; }
  /// The body to which a ball or free joint's motion is relative; else empty.
  const std::string& relative_to() const { return relative_to_; }
  Of of() const { return of_; }
  const std::vector<double>& positions() const { return positions_; }
  const std::vector<double>& speeds() const { return speeds_; }

 private:
  std::string name_, relative_to_;
  Of of_;
  std::vector<double> positions_, speeds_;
};

namespace detail {

/// A ball joint, by R_b^p and w_pb^b; a free joint, with r_pb^p and v_pb|p^p. The body is the frame b.
VECTRIX_EXPORT NamedStart start_of(const NamedMovingDcm& R_p_from_b);
VECTRIX_EXPORT NamedStart start_of(const NamedMovingTransform& X_p_from_b);

template <class Name, class Q, class U>
  requires std::convertible_to<const Name&, std::string>
struct Started<Name, Q, U> {
  static constexpr bool fits = starts_angle<Q, U> || starts_length<Q, U>;
  static NamedStart make(const Name& name, const Q& coordinate, const U& rate) {
    if constexpr (starts_angle<Q, U>)
      return {trusted, name, JointKind::hinge, {coordinate.value()}, {rate.value()}};
    else
      return {trusted, name, JointKind::slider, {coordinate.value()}, {rate.value()}};
  }
};
template <class Name, class Q, class U, class V, class W>
  requires std::convertible_to<const Name&, std::string>
struct Started<Name, Q, U, V, W> {
  static constexpr bool fits = starts_angle<Q, U> && starts_angle<V, W>;
  static NamedStart make(const Name& name, const Q& angle_1, const U& rate_1, const V& angle_2,
                         const W& rate_2) {
    return {trusted,
            name,
            JointKind::gimbal,
            {angle_1.value(), angle_2.value()},
            {rate_1.value(), rate_2.value()}};
  }
};
template <> struct Started<NamedMovingDcm> {
  static constexpr bool fits = true;
  static NamedStart make(const NamedMovingDcm& R_p_from_b) { return start_of(R_p_from_b); }
};
template <> struct Started<NamedMovingTransform> {
  static constexpr bool fits = true;
  static NamedStart make(const NamedMovingTransform& X_p_from_b) { return start_of(X_p_from_b); }
};

}  // namespace detail

/// The speed of a rotor relative to its body; a mode's coordinate, kg^1/2 m, and its rate.
inline NamedStart spins(std::string name, const Quantity<si::angular_velocity>& speed) {
  return {detail::trusted, std::move(name), NamedStart::Rotor{}, {}, {speed.value()}};
}
inline NamedStart deflects(std::string name, double coordinate, double rate) {
  return {detail::trusted, std::move(name), NamedStart::Mode{}, {coordinate}, {rate}};
}

namespace detail {

/// A state of a craft in plain numbers.
struct NamedView {
  const NamedCraftCore* core;
  const double* y;
};
enum class NamedNumber { angle, angle_rate, length, length_rate, spin, deflection, deflection_rate };
/// Throws BadInput if the craft has no such number; `axis` is 1, or 2 of a gimbal.
VECTRIX_EXPORT double named_number(const NamedView& view, NamedNumber number, std::string_view name,
                                   int axis);

/// Typed access to the numbers of a state, by name. A name, an axis or a unit that the craft does not have
/// throws BadInput. A joint has the name of the body that hangs on it.
template <class Derived> class NamedNumbers {
 public:
  /// The angle of a hinge, or of a gimbal about its axis 1 or 2, and its rate.
  Quantity<si::angle> angle(std::string_view body, int axis = 1) const {
    return get<si::angle>(NamedNumber::angle, body, axis);
  }
  Quantity<si::angular_velocity> angle_rate(std::string_view body, int axis = 1) const {
    return get<si::angular_velocity>(NamedNumber::angle_rate, body, axis);
  }
  /// The length of a slider, and its rate.
  Quantity<si::length> length(std::string_view body) const {
    return get<si::length>(NamedNumber::length, body);
  }
  Quantity<si::velocity> length_rate(std::string_view body) const {
    return get<si::velocity>(NamedNumber::length_rate, body);
  }
  /// The speed of a rotor relative to its body.
  Quantity<si::angular_velocity> spin(std::string_view rotor) const {
    return get<si::angular_velocity>(NamedNumber::spin, rotor);
  }
  /// The coordinate of a mode, kg^1/2 m, and its rate, kg^1/2 m/s.
  double deflection(std::string_view mode) const {
    return named_number(view(), NamedNumber::deflection, mode, 1);
  }
  double deflection_rate(std::string_view mode) const {
    return named_number(view(), NamedNumber::deflection_rate, mode, 1);
  }

 private:
  NamedView view() const { return static_cast<const Derived&>(*this).view(); }
  template <class U> Quantity<U> get(NamedNumber number, std::string_view name, int axis = 1) const {
    return Quantity<U>::from_value(named_number(view(), number, name, axis));
  }
};

}  // namespace detail

/// The state of a NamedSpacecraft: the numbers that are integrated. Made by craft.state().
class VECTRIX_EXPORT NamedState : public detail::NamedNumbers<NamedState> {
 public:
  NamedState(detail::Trusted, std::shared_ptr<const detail::NamedCraftCore> core, std::vector<double> numbers)
      : core_(std::move(core)), numbers_(std::move(numbers)) {}

  [[nodiscard]] const std::vector<double>& numbers() const& { return numbers_; }
  [[nodiscard]] std::vector<double> numbers() && { return std::move(numbers_); }

  /// R_h^i, the nearest rotation to the integrated numbers, and w_ih^h.
  [[nodiscard]] NamedMovingDcm turning() const;
  /// With r_ih^i and v_ih|i^i. Throws BadInput if the hub is only turning.
  [[nodiscard]] NamedMovingTransform hub_motion() const;

  [[nodiscard]] detail::NamedView view() const { return {core_.get(), numbers_.data()}; }

 private:
  std::shared_ptr<const detail::NamedCraftCore> core_;
  std::vector<double> numbers_;
};

}  // namespace vectrix
