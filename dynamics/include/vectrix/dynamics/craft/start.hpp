#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <vectrix/dynamics/craft/craft_numbers.hpp>
#include <vectrix/dynamics/craft/spacecraft.hpp>
#include <vectrix/dynamics/craft/starting.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>

namespace vectrix {

// The starts of joints, rotors and modes. A joint has the name of the body that hangs on it.
template <class B, JointKind kind_of_joint, class RelativeTo = void> struct JointStart {
  using of = B;
  using relative_to = RelativeTo;
  static constexpr JointKind kind = kind_of_joint;
  std::array<double, detail::counts_of(kind).positions> positions;
  std::array<double, detail::counts_of(kind).speeds> speeds;
};
template <class W> struct SpinStart {
  using of = W;
  double speed;
};
template <class A, std::size_t count_of_modes> struct DeflectionStart {
  using of = A;
  static constexpr std::size_t count = count_of_modes;
  std::array<double, count> coordinates, rates;
};

namespace detail {

template <JointKind kind, class Q, class U>
inline constexpr bool is_axis =
    moves_by<typename JointUnits<kind>::coordinate, typename JointUnits<kind>::speed, Q, U>;

template <class B, class Q, class U> struct Started<Of<B>, Q, U> {
  static constexpr JointKind kind = is_axis<JointKind::hinge, Q, U> ? JointKind::hinge : JointKind::slider;
  static constexpr bool fits = is_axis<kind, Q, U>;
  static JointStart<B, kind> make(Of<B>, const Quantity<typename JointUnits<kind>::coordinate>& coordinate,
                                  const Quantity<typename JointUnits<kind>::speed>& rate) {
    return {{coordinate.value()}, {rate.value()}};
  }
};
template <class B, class Q, class U, class V, class W> struct Started<Of<B>, Q, U, V, W> {
  static constexpr bool fits = is_axis<JointKind::hinge, Q, U> && is_axis<JointKind::hinge, V, W>;
  using Angle = Quantity<si::angle>;
  using Rate = Quantity<si::angular_velocity>;
  static JointStart<B, JointKind::gimbal> make(Of<B>, const Angle& angle_1, const Rate& rate_1,
                                               const Angle& angle_2, const Rate& rate_2) {
    return {{angle_1.value(), angle_2.value()}, {rate_1.value(), rate_2.value()}};
  }
};
template <class P, class B> struct Started<MovingDcm<P, B>> {
  static constexpr bool fits = true;
  static JointStart<B, JointKind::ball, P> make(const MovingDcm<P, B>& R_p_from_b) {
    JointStart<B, JointKind::ball, P> start;
    put_numbers(start.positions.data(), R_p_from_b.rotation.matrix());
    put_numbers(start.speeds.data(), R_p_from_b.angular_velocity.coordinates());
    return start;
  }
};
template <class P, class B> struct Started<MovingTransform<P, B>> {
  static constexpr bool fits = true;
  static JointStart<B, JointKind::free, P> make(const MovingTransform<P, B>& X_p_from_b) {
    JointStart<B, JointKind::free, P> start;
    double* next = put_numbers(start.positions.data(), X_p_from_b.turning.rotation.matrix());
    put_numbers(next, X_p_from_b.translation.coordinates());
    next = put_numbers(start.speeds.data(), X_p_from_b.turning.angular_velocity.coordinates());
    put_numbers(next, X_p_from_b.velocity.coordinates());
    return start;
  }
};

}  // namespace detail

/// The speed of a rotor relative to its body.
template <Point W> SpinStart<W> spins(Of<W>, const Quantity<si::angular_velocity>& speed) {
  return {speed.value()};
}
template <class W, class Given>
  requires(!std::convertible_to<const Given&, Quantity<si::angular_velocity>>)
auto spins(Of<W>, const Given&) -> Refused = delete;  // a speed in rad/s

/// The coordinates of the modes of an appendage, kg^1/2 m, and their rates, kg^1/2 m/s.
template <Point A, std::size_t count>
DeflectionStart<A, count> deflects(Of<A>, const std::array<double, count>& coordinates,
                                   const std::array<double, count>& rates) {
  return {coordinates, rates};
}
template <Point A> DeflectionStart<A, 1> deflects(Of<A>, double coordinate, double rate) {
  return {{coordinate}, {rate}};
}

// The mistakes in a list of starts, for messages.
template <class F> struct StartIsMissing {};
template <class F> struct StartIsGivenTwice {};
template <class F> struct NoStartOf {};
template <class Given> struct IsNoStart {};
template <class Start, class Part> struct StartIsNotThatOf {};
template <class Given, class Motion> struct HubMovesWith {};

namespace detail {

template <class Given> inline constexpr bool is_start = requires {
  typename Given::of;
};

/// What the motion of a hub starts with.
template <class Shape>
struct HubStart : std::type_identity<MovingDcm<typename Shape::inertial, typename Shape::hub>> {};
template <class Shape>
requires Shape::free struct HubStart<Shape>
    : std::type_identity<MovingTransform<typename Shape::inertial, typename Shape::hub>> {
};

template <class Shape, class Start> constexpr bool start_fits() {
  using F = typename Start::of;
  if constexpr (!Shape::template has_part<F>) {
    return false;
  } else if constexpr (requires { Start::kind; }) {
    if constexpr (!Shape::template has_joint_of<F, Start::kind>)
      return false;
    else
      return std::is_void_v<typename Start::relative_to> ||
             std::is_same_v<typename Start::relative_to, typename Shape::template Part<F>::carrier>;
  } else if constexpr (requires { Start::count; }) {
    return Shape::template has_modes<F> && Shape::template Part<F>::counts.modes == Start::count;
  } else {
    return Shape::template has_rotor<F>;
  }
}
template <class Part>
inline constexpr bool moves = Part::counts.speeds + Part::counts.rotors + Part::counts.modes > 0;

template <std::size_t i, class... F>
inline constexpr bool is_again =
    first_of<std::is_same_v<std::tuple_element_t<i, std::tuple<F...>>, F>...>() != i;

/// The first mistake in the starts of a craft; Nothing if each part that moves has one, of its kind.
template <class Shape, class... Starts> struct StartFault {
  template <class F> static constexpr bool given = (std::is_same_v<F, typename Starts::of> || ...);
  template <std::size_t... i> static constexpr std::size_t again(std::index_sequence<i...>) {
    return first_of<is_again<i, typename Starts::of...>...>();
  }
  template <class... Parts> static constexpr auto missing(std::type_identity<std::tuple<Parts...>>) {
    constexpr std::size_t at = first_of<(moves<Parts> && !given<typename Parts::frame>)...>();
    if constexpr (at == nowhere) {
      return std::type_identity<Nothing>{};
    } else {
      using Part = std::tuple_element_t<at, std::tuple<Parts...>>;
      return std::type_identity<StartIsMissing<typename Part::frame>>{};
    }
  }
  static constexpr auto fault() {
    constexpr std::size_t bad = first_of<!start_fits<Shape, Starts>()...>();
    constexpr std::size_t twice = again(std::index_sequence_for<Starts...>{});
    if constexpr (bad != nowhere) {
      using Start = std::tuple_element_t<bad, std::tuple<Starts...>>;
      if constexpr (Shape::template has_part<typename Start::of>) {
        return std::type_identity<
            StartIsNotThatOf<Start, typename Shape::template Part<typename Start::of>>>{};
      } else {
        return std::type_identity<NoStartOf<typename Start::of>>{};
      }
    } else if constexpr (twice != nowhere) {
      return std::type_identity<
          StartIsGivenTwice<typename std::tuple_element_t<twice, std::tuple<Starts...>>::of>>{};
    } else {
      return missing(std::type_identity<typename Shape::parts>{});
    }
  }
  using type = typename decltype(fault())::type;
};
template <class Shape, class Motion, class Tuple> struct FaultOfState;
template <class Shape, class Motion, class... Starts>
struct FaultOfState<Shape, Motion, std::tuple<Starts...>> {
  using Wanted = typename HubStart<Shape>::type;
  static constexpr auto fault() {
    constexpr std::size_t no_start = first_of<!is_start<Starts>...>();
    if constexpr ((std::is_same_v<Starts, Refused> || ...)) {
      return std::type_identity<Refused>{};
    } else if constexpr (no_start != nowhere) {
      return std::type_identity<IsNoStart<std::tuple_element_t<no_start, std::tuple<Starts...>>>>{};
    } else if constexpr (!std::is_same_v<Motion, Wanted>) {
      return std::type_identity<HubMovesWith<Motion, Wanted>>{};
    } else {
      return StartFault<Shape, Starts...>{};
    }
  }
  using type = typename decltype(fault())::type;
};

}  // namespace detail
}  // namespace vectrix
