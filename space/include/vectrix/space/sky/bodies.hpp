#pragma once

#include <concepts>

#include <vectrix/frames/frame.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// How a body is seen from a point. The caller has to say it: geometric, light_time or apparent.
///     geometric     where it is at this instant                        SPICE: NONE
///     light_time    where it was when the light left                   CN; LT with one iteration
///     apparent      light_time with the aberration by the motion of the observer     CN+S, LT+S
struct Geometric {};
struct LightTime {};
struct Apparent {};
inline constexpr Geometric geometric{};
inline constexpr LightTime light_time{};
inline constexpr Apparent apparent{};

template <class C>
concept Correction = std::same_as<C, Geometric> || std::same_as<C, LightTime> || std::same_as<C, Apparent>;

/// The point from which a body is seen: seen_from<Satellite>.
template <class P> struct SeenFrom {};
template <Point P> inline constexpr SeenFrom<P> seen_from{};

/// The points of the sky. They have their own namespace, so that users can use the short names.
namespace sky {

/// The centre of the Sun.
struct Sun : named_point {};
/// The centre of the Moon.
struct Moon : named_point {};
/// The centres of the planets. Those of Jupiter to Neptune stand for the centres of mass with their moons,
/// up to 300 km away.
struct Mercury : named_point {};
struct Venus : named_point {};
struct Mars : named_point {};
struct Jupiter : named_point {};
struct Saturn : named_point {};
struct Uranus : named_point {};
struct Neptune : named_point {};

/// Where a body is seen: another point than where it is.
template <class Body, class Correction> struct Image : named_point {};

/// Nominal radius of the Sun (IAU 2015, resolution B3).
inline constexpr Quantity<si::length> sun_radius = 6.957e8 * si::metre;
/// Mean radius of the Moon (IAU working group on cartographic coordinates, 2015).
inline constexpr Quantity<si::length> moon_radius = 1.7374e6 * si::metre;

}  // namespace sky

namespace detail {

/// The bodies where they have no types.
enum class Body { sun, moon, mercury, venus, mars, jupiter, saturn, uranus, neptune, none };

template <class P> inline constexpr Body body_of = Body::none;
template <> inline constexpr Body body_of<sky::Sun> = Body::sun;
template <> inline constexpr Body body_of<sky::Moon> = Body::moon;
template <> inline constexpr Body body_of<sky::Mercury> = Body::mercury;
template <> inline constexpr Body body_of<sky::Venus> = Body::venus;
template <> inline constexpr Body body_of<sky::Mars> = Body::mars;
template <> inline constexpr Body body_of<sky::Jupiter> = Body::jupiter;
template <> inline constexpr Body body_of<sky::Saturn> = Body::saturn;
template <> inline constexpr Body body_of<sky::Uranus> = Body::uranus;
template <> inline constexpr Body body_of<sky::Neptune> = Body::neptune;

}  // namespace detail

/// The Sun, the Moon and the planets from Mercury to Neptune, but for the Earth: that is earth::Gcrf.
template <class B>
concept SkyBody = (detail::body_of<B> != detail::Body::none);

namespace detail {

template <class B, class C> struct SeenAs : std::type_identity<sky::Image<B, C>> {};
template <class B> struct SeenAs<B, Geometric> : std::type_identity<B> {};

/// The Sun, or where it is seen.
template <class P> inline constexpr bool is_sun = false;
template <> inline constexpr bool is_sun<sky::Sun> = true;
template <class C> inline constexpr bool is_sun<sky::Image<sky::Sun, C>> = true;

}  // namespace detail

/// The point at which a body is seen with a correction: the body itself if that is geometric.
template <SkyBody B, Correction C> using Seen = typename detail::SeenAs<B, C>::type;

}  // namespace vectrix
