#pragma once

#include <Eigen/Core>
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/forces.hpp>
#include <vectrix/dynamics/craft/start.hpp>
#include <vectrix/frames/print.hpp>

namespace vectrix {

/// A torque of the body on its rotor, N m; the effort of a joint, N m or N; a torque on a body or mount, N m,
/// and a force through its origin, N, by its three coordinates in a frame of the craft. Made by
/// motor_input(), effort_input(), torque_input() and force_input().
template <class W> struct MotorInput {};
template <class B> struct EffortInput {};
template <class B, class D> struct TorqueInput {};
template <class B, class D> struct ForceInput {};

template <Point W> MotorInput<W> motor_input(Of<W>) {
  return {};
}
template <Frame B> EffortInput<B> effort_input(Of<B>) {
  return {};
}
template <Frame B, Frame D> TorqueInput<B, D> torque_input(Of<B>, In<D>) {
  return {};
}
template <Frame B, Frame D> ForceInput<B, D> force_input(Of<B>, In<D>) {
  return {};
}

/// What may act on a craft besides its loads. Made by inputs().
template <class... Input> struct CraftInputs {};
template <class... Input> CraftInputs<Input...> inputs(const Input&...) {
  return {};
}

// The mistakes in a list of inputs, for messages.
template <class Input> struct NoInputOfTheCraft {};
template <class Input> struct InputIsGivenTwice {};

namespace detail {

/// How an input acts on the craft C: `size` numbers, 0 if it does not.
template <class C, class Input> struct InputOn { static constexpr std::size_t size = 0; };

template <class C, class W>
requires C::shape::template has_rotor<W> struct InputOn<C, MotorInput<W>> {
  static constexpr std::size_t size = 1;
  static std::vector<std::string> names() { return {"motor of " + frame_name<W>() + " [N m]"}; }
  template <class S> static void act(Forces<C, S>& forces, const S* u) {
    forces.motor(of<W>, Quantity<si::torque, S>::from_value(u[0]));
  }
};
template <class C, class B> constexpr std::size_t numbers_of_effort() {
  if constexpr (C::shape::template has_axes<B>)
    return C::shape::template Part<B>::counts.speeds;
  else if constexpr (C::shape::template has_joint_of<B, JointKind::ball> ||
                     C::shape::template has_joint_of<B, JointKind::free>)
    return 3;
  else
    return 0;
}
template <class U, class D, class S> Vector<D, U, S> input_vector(const S* u) {
  return {trusted, Eigen::Matrix<S, 3, 1>(u[0], u[1], u[2])};
}
inline std::vector<std::string> names_of_three(const std::string& what, const char* unit) {
  std::vector<std::string> names;
  for (const char* axis : {"x", "y", "z"}) names.push_back(what + " " + axis + " [" + unit + "]");
  return names;
}
template <class C, class B>
  requires(numbers_of_effort<C, B>() > 0)
struct InputOn<C, EffortInput<B>> {
  static constexpr std::size_t size = numbers_of_effort<C, B>();
  static constexpr bool slides = C::shape::template has_joint_of<B, JointKind::slider>;
  static std::vector<std::string> names() {
    const std::string name = "effort of " + frame_name<B>();
    if constexpr (size == 3)
      return names_of_three(name, "N m");
    else if constexpr (size == 2)
      return {name + " 1 [N m]", name + " 2 [N m]"};
    else
      return {name + (slides ? " [N]" : " [N m]")};
  }
  template <class S> static void act(Forces<C, S>& forces, const S* u) {
    using Effort = Quantity<std::conditional_t<slides, si::force, si::torque>, S>;
    if constexpr (size == 3)
      forces.effort(of<B>, input_vector<si::torque, B>(u));
    else if constexpr (size == 2)
      forces.effort(of<B>, Effort::from_value(u[0]), Effort::from_value(u[1]));
    else
      forces.effort(of<B>, Effort::from_value(u[0]));
  }
};
template <class C, class B, class D>
  requires(C::shape::template has_place<B>&& C::shape::template has_frame<D>)
struct InputOn<C, TorqueInput<B, D>> {
  static constexpr std::size_t size = 3;
  static std::vector<std::string> names() {
    return names_of_three("torque on " + frame_name<B>() + " in " + frame_name<D>(), "N m");
  }
  template <class S> static void act(Forces<C, S>& forces, const S* u) {
    forces.torque(of<B>, input_vector<si::torque, D>(u));
  }
};
template <class C, class B, class D>
  requires(C::shape::template has_place<B>&& C::shape::template has_frame<D>)
struct InputOn<C, ForceInput<B, D>> {
  static constexpr std::size_t size = 3;
  static std::vector<std::string> names() {
    return names_of_three("force on " + frame_name<B>() + " in " + frame_name<D>(), "N");
  }
  template <class S> static void act(Forces<C, S>& forces, const S* u) {
    forces.force(of<B>, input_vector<si::force, D>(u));
  }
};

template <class C, class... Input> constexpr auto fault_of_inputs() {
  constexpr std::size_t bad = first_of<(InputOn<C, Input>::size == 0)...>();
  constexpr std::size_t twice = []<std::size_t... i>(std::index_sequence<i...>) {
    return first_of<is_again<i, Input...>...>();
  }
  (std::index_sequence_for<Input...>{});
  if constexpr (bad != nowhere)
    return std::type_identity<NoInputOfTheCraft<std::tuple_element_t<bad, std::tuple<Input...>>>>{};
  else if constexpr (twice != nowhere)
    return std::type_identity<InputIsGivenTwice<std::tuple_element_t<twice, std::tuple<Input...>>>>{};
  else
    return std::type_identity<Nothing>{};
}

/// Where the numbers of an input begin.
template <class C, class Wanted, class... Input> constexpr std::size_t input_at() {
  std::size_t at = 0;
  bool found = false;
  ((found = found || std::is_same_v<Wanted, Input>, at += found ? 0 : InputOn<C, Input>::size), ...);
  return at;
}

/// The load of all inputs, whose numbers are at `u`.
template <class C, class S, class... Input> struct InputLoad {
  const S* u;
  void operator()(const Now<C, S>&, Forces<C, S>& forces) const {
    (InputOn<C, Input>::template act<S>(forces, u + input_at<C, Input, Input...>()), ...);
  }
};

}  // namespace detail
}  // namespace vectrix
