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

/// The frame's name as the compiler writes it, for messages.
template <Frame F> std::string frame_name() {
  const std::string_view signature = __PRETTY_FUNCTION__;
  const auto begin = signature.find("F = ") + 4;
  return std::string{signature.substr(begin, signature.find_first_of(";]", begin) - begin)};
}

// The words of the doors and queries: to<B>, from<A>, in<C>, of<B>, relative_to<A>.
template <Frame F> struct To {};
template <Frame F> struct From {};
template <Frame F> struct In {};
template <Frame F> struct Of {};
template <Frame F> struct RelativeTo {};

template <Frame F> inline constexpr To<F> to{};
template <Frame F> inline constexpr From<F> from{};
template <Frame F> inline constexpr In<F> in{};
template <Frame F> inline constexpr Of<F> of{};
template <Frame F> inline constexpr RelativeTo<F> relative_to{};

}  // namespace vectrix
