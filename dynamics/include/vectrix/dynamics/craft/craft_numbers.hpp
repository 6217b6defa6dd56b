#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vectrix/dynamics/craft/spacecraft.hpp>

namespace vectrix {
namespace detail {

/// The units of the numbers of a joint with axes.
template <JointKind> struct JointUnits {
  using coordinate = si::angle;
  using speed = si::angular_velocity;
  using acceleration = si::angular_acceleration;
  using effort = si::torque;
};
template <> struct JointUnits<JointKind::slider> {
  using coordinate = si::length;
  using speed = si::velocity;
  using acceleration = si::acceleration;
  using effort = si::force;
};

/// One quantity of a hinge or slider; two of a gimbal.
template <class U, JointKind kind, class S> struct AxisNumbers {
  using type = Quantity<U, S>;
  static type read(const S* numbers) { return type::from_value(numbers[0]); }
};
template <class U, class S> struct AxisNumbers<U, JointKind::gimbal, S> {
  using type = std::array<Quantity<U, S>, 2>;
  static type read(const S* numbers) {
    return {Quantity<U, S>::from_value(numbers[0]), Quantity<U, S>::from_value(numbers[1])};
  }
};

/// Typed access to the numbers of a state of the craft C. A joint has the name of the body that hangs on it.
template <class Derived, class C, class S> class CraftNumbers {
  using Shape = typename C::shape;

 public:
  /// The angle of a hinge, the length of a slider, both angles of a gimbal.
  template <class B>
  requires Shape::template has_axes<B> auto coordinate(Of<B>) const {
    constexpr JointKind kind = Shape::template Part<B>::joint;
    return AxisNumbers<typename JointUnits<kind>::coordinate, kind, S>::read(y() +
                                                                             Shape::template position_at<B>);
  }
  template <class B>
  auto coordinate(  // of a hinge, a slider or a gimbal: of a body of the craft C that hangs on one
      Of<B>) const -> Refused = delete;

  /// Its rate.
  template <class B>
  requires Shape::template has_axes<B> auto speed(Of<B>) const {
    constexpr JointKind kind = Shape::template Part<B>::joint;
    return AxisNumbers<typename JointUnits<kind>::speed, kind, S>::read(y() + Shape::template speed_at<B>);
  }
  template <class B>
  auto speed(  // of a hinge, a slider or a gimbal: of a body of the craft C that hangs on one
      Of<B>) const -> Refused = delete;

  /// The speed of a rotor relative to its body.
  template <class W>
  requires Shape::template has_rotor<W> Quantity<si::angular_velocity, S> spin(Of<W>) const {
    return Quantity<si::angular_velocity, S>::from_value(y()[Shape::template spin_at<W>]);
  }
  template <class W> auto spin(Of<W>) const -> Refused = delete;  // of a rotor of the craft C

  /// The coordinates of the modes of an appendage, kg^1/2 m, and their rates, kg^1/2 m/s.
  template <class A>
  requires Shape::template has_modes<A> auto deflections(Of<A>) const {
    return modal<A>(Shape::template modes_at<A>);
  }
  template <class A> auto deflections(Of<A>) const -> Refused = delete;  // of modes of the craft C
  template <class A>
  requires Shape::template has_modes<A> auto deflection_rates(Of<A>) const {
    return modal<A>(Shape::template modes_at<A> + Shape::total.modes);
  }
  template <class A> auto deflection_rates(Of<A>) const -> Refused = delete;  // of modes of the craft C

 private:
  const S* y() const { return static_cast<const Derived&>(*this).data(); }
  template <class A> auto modal(std::size_t at) const {
    std::array<S, Shape::template Part<A>::counts.modes> numbers;
    std::copy(y() + at, y() + at + numbers.size(), numbers.begin());
    return numbers;
  }
};

}  // namespace detail
}  // namespace vectrix
