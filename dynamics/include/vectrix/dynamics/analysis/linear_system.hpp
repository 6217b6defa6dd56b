#pragma once

#include <Eigen/Core>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/analysis/inputs.hpp>

namespace vectrix {

/// Small differences x from a motion, under small inputs u, and what they change in the outputs:
///     x' = A x + B u,   y = C x + D u
/// Each row and column has a name with its unit; in a system of your own the states may have none.
struct LinearSystem {
  Eigen::MatrixXd A, B, C, D;
  std::vector<std::string> state_names, input_names, output_names;
};

/// The linear system of a craft, whose rows and columns answer to words: one number is an index, several are
/// a sequence of Eigen's, so that
///     system.A(system.rate(of<Hub>), system.attitude_error(of<Hub>))      is a 3x3 block
///     system.B(system.speed(of<Panel>), system.input(motor_input(of<Wheel>)))  is a number
/// Made by linearise().
template <CraftType Craft, class... Input> class LinearCraft : public LinearSystem {
  using Shape = typename Craft::shape;
  template <class F> static constexpr bool is_hub = std::is_same_v<F, typename Shape::hub>;
  template <class F>
  static constexpr bool is_free = is_hub<F> ? Shape::free : Shape::template has_joint_of<F, JointKind::free>;
  template <class F>
  static constexpr bool turns = is_hub<F> || Shape::template has_joint_of<F, JointKind::ball> ||
                                Shape::template has_joint_of<F, JointKind::free>;

  // Each quaternion is a number longer than its error: how many are before those of F.
  template <class F, class... Part>
  static constexpr std::size_t quaternions_before(std::type_identity<std::tuple<Part...>>) {
    std::size_t count = 1;
    bool found = false;
    ((found = found || std::is_same_v<typename Part::frame, F>,
      count += !found && !is_hub<typename Part::frame> && turns<typename Part::frame> ? 1 : 0),
     ...);
    return count;
  }
  template <class F> static constexpr std::size_t turning_before() {
    return quaternions_before<F>(std::type_identity<typename Shape::parts>{});
  }
  static constexpr std::size_t all_turning() { return turning_before<void>(); }
  template <std::size_t at, std::size_t count> static auto sequence() {
    if constexpr (count == 1)
      return static_cast<Eigen::Index>(at);
    else
      return Eigen::seqN(static_cast<Eigen::Index>(at), Eigen::fix<static_cast<int>(count)>);
  }
  template <class F> static constexpr std::size_t position() {
    return Shape::template position_at<F> - turning_before<F>();
  }
  template <class F> static constexpr std::size_t speed_of() {
    return Shape::template speed_at<F> - all_turning();
  }

 public:
  explicit LinearCraft(LinearSystem system) : LinearSystem(std::move(system)) {}

  /// theta of the hub, or of a body on a ball or free joint relative to its parent, in its own axes.
  template <class B>
    requires turns<B>
  static auto attitude_error(Of<B>) {
    if constexpr (is_hub<B>)
      return sequence<0, 3>();
    else
      return sequence<position<B>(), 3>();
  }
  /// Its angular velocity.
  template <class B>
    requires turns<B>
  static auto rate(Of<B>) {
    if constexpr (is_hub<B>)
      return sequence<3, 3>();
    else
      return sequence<speed_of<B>(), 3>();
  }
  /// Of a free hub, in its own axes; of a body on a free joint, in those of its parent.
  template <class B>
    requires is_free<B>
  static auto place(Of<B>) {
    if constexpr (is_hub<B>)
      return sequence<6, 3>();
    else
      return sequence<position<B>() + 3, 3>();
  }
  template <class B>
    requires is_free<B>
  static auto velocity(Of<B>) {
    if constexpr (is_hub<B>)
      return sequence<9, 3>();
    else
      return sequence<speed_of<B>() + 3, 3>();
  }
  /// Of a hinge, a slider or a gimbal.
  template <class B>
  requires Shape::template has_axes<B> static auto coordinate(Of<B>) {
    return sequence<position<B>(), Shape::template Part<B>::counts.speeds>();
  }
  template <class B>
  requires Shape::template has_axes<B> static auto speed(Of<B>) {
    return sequence<speed_of<B>(), Shape::template Part<B>::counts.speeds>();
  }
  /// Of a rotor.
  template <class W>
  requires Shape::template has_rotor<W> static auto spin(Of<W>) {
    return sequence<Shape::template spin_at<W> - all_turning(), 1>();
  }
  /// Of the modes of an appendage.
  template <class M>
  requires Shape::template has_modes<M> static auto deflections(Of<M>) {
    return sequence<Shape::template modes_at<M> - all_turning(), Shape::template Part<M>::counts.modes>();
  }
  template <class M>
  requires Shape::template has_modes<M> static auto deflection_rates(Of<M>) {
    return sequence<Shape::template modes_at<M> - all_turning() + Shape::total.modes,
                    Shape::template Part<M>::counts.modes>();
  }
  /// The columns of an input.
  template <class Wanted>
    requires(std::is_same_v<Wanted, Input> || ...)
  static auto input(const Wanted&) {
    return sequence<detail::input_at<Craft, Wanted, Input...>(), detail::InputOn<Craft, Wanted>::size>();
  }

  template <class B>
  static auto attitude_error(Of<B>) -> Refused = delete;                  // of the hub, a ball or free joint
  template <class B> static auto rate(Of<B>) -> Refused = delete;         // of the hub, a ball or free joint
  template <class B> static auto place(Of<B>) -> Refused = delete;        // of a free hub, or on a free joint
  template <class B> static auto velocity(Of<B>) -> Refused = delete;     // of a free hub, or on a free joint
  template <class B> static auto coordinate(Of<B>) -> Refused = delete;   // of a hinge, a slider or a gimbal
  template <class B> static auto speed(Of<B>) -> Refused = delete;        // of a hinge, a slider or a gimbal
  template <class W> static auto spin(Of<W>) -> Refused = delete;         // of a rotor of the craft
  template <class M> static auto deflections(Of<M>) -> Refused = delete;  // of modes of the craft
  template <class M> static auto deflection_rates(Of<M>) -> Refused = delete;    // of modes of the craft
  template <class Wanted> static auto input(const Wanted&) -> Refused = delete;  // one that was given
};

}  // namespace vectrix
