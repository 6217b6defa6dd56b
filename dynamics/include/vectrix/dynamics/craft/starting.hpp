#pragma once

#include <concepts>
#include <vectrix/dynamics/craft/about_frames.hpp>
#include <vectrix/frames/operators.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {
namespace detail {

template <class Coordinate, class Speed, class Q, class U>
inline constexpr bool moves_by =
    std::convertible_to<const Q&, Quantity<Coordinate>>&& std::convertible_to<const U&, Quantity<Speed>>;
template <class Q, class U>
inline constexpr bool starts_angle = moves_by<si::angle, si::angular_velocity, Q, U>;
template <class Q, class U> inline constexpr bool starts_length = moves_by<si::length, si::velocity, Q, U>;

/// What starts() makes of what it is given, in types and in names: one function for all, so that a refusal
/// names few.
template <class First, class... Given> struct Started { static constexpr bool fits = false; };

/// Whether a start is meant: of<B> or several of them, or a name and quantities.
template <class Given> inline constexpr bool starts_with_unit = false;
template <class U> inline constexpr bool starts_with_unit<Quantity<U>> = true;
template <class First, class... Given>
inline constexpr bool is_start_of = is_of<First> || (starts_with_unit<Given> || ...);

}  // namespace detail

/// The start of a joint: of a hinge its angle and rate, of a slider its length and rate, of a gimbal the
/// angle and rate about each axis; of a ball joint R_b^p and w_pb^b, of a free joint X_b^p with its rates. Of
/// several hinges or sliders, one value for all, or a std::array. Of a NamedSpacecraft with its name:
///     starts(of<Panel>, 0.1 * rad, 0.0 * (rad / s)), starts(R_p_from_b)
///     starts(of_numbered<Panel, 1, 2>, std::array{0.1 * rad, 0.2 * rad}, 0.0 * (rad / s))
///     starts("panel", 0.1 * rad, 0.0 * (rad / s))
template <class First, class... Given>
  requires(detail::Started<First, Given...>::fits)
auto starts(const First& first, const Given&... given) {
  return detail::Started<First, Given...>::make(first, given...);
}
template <class First, class... Given>
  requires(detail::is_start_of<First, Given...> && !detail::Started<First, Given...>::fits)
auto starts(  // angle and rate, of a gimbal both; length and rate; of each a value, or a std::array of all
    const First&, const Given&...) -> Refused = delete;

}  // namespace vectrix
