#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

namespace vectrix {

/// A frame is an empty type of the user's with a motion property, never instantiated:
///     struct Gcrf : vectrix::inertial_frame {};
///     struct Body : vectrix::moving_frame {};
///     template <int I> struct Wheel : vectrix::moving_frame {};
/// Inertial: Newton's and Euler's laws hold in it. Moving: nothing is claimed.
struct inertial_frame {};
struct moving_frame {};

template <class F>
concept Frame = std::same_as<F, std::remove_cv_t<F>> && std::is_empty_v<F> &&
                (std::derived_from<F, inertial_frame> !=
                 std::derived_from<F, moving_frame>)&&!std::same_as<F, inertial_frame> &&
                !std::same_as<F, moving_frame>;

template <class F>
concept InertialFrame = Frame<F> && std::derived_from<F, inertial_frame>;

/// A point is an empty type of the user's as well, and a frame stands for its own origin:
///     struct CentreOfMass : vectrix::point {};
struct point {};

template <class P>
concept Point = Frame<P> ||
    (std::same_as<P, std::remove_cv_t<P>>&& std::is_empty_v<P>&& std::derived_from<P, point> &&
     !std::same_as<P, point>);

/// The frame's name as the compiler writes it, for messages.
template <Point F> std::string frame_name() {
  const std::string_view signature = __PRETTY_FUNCTION__;
  const auto begin = signature.find("F = ") + 4;
  return std::string{signature.substr(begin, signature.find_first_of(";]", begin) - begin)};
}

// The words of the doors and queries: to<B>, from<A>, in<C>, of<B>, relative_to<A>. Motion may be that of a
// point.
template <Frame F> struct To {};
template <Frame F> struct From {};
template <Frame F> struct In {};
template <Point P> struct Of {};
template <Point P> struct RelativeTo {};
template <Frame A> struct ObservedFrom {};

template <Frame F> inline constexpr To<F> to{};
template <Frame F> inline constexpr From<F> from{};
template <Frame F> inline constexpr In<F> in{};
template <Point P> inline constexpr Of<P> of{};
template <Point P> inline constexpr RelativeTo<P> relative_to{};
template <Frame A> inline constexpr ObservedFrom<A> observed_from{};  // where who watches a change is fixed

}  // namespace vectrix
