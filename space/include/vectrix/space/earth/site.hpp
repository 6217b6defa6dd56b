#pragma once

#include <Eigen/Core>
#include <concepts>
#include <string>
#include <type_traits>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/transform.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix {

/// Frames with the axes of a place on the Earth. Which axes they are is part of the frame, because the same
/// numbers mean another direction in the other:
///     struct Station : east_north_up_frame {};       x east, y north, z up
///     struct Runway : north_east_down_frame {};      x north, y east, z down
/// Up is the normal of the ellipsoid, not the direction from the centre of the Earth.
struct east_north_up_frame : moving_frame {};
struct north_east_down_frame : moving_frame {};

namespace detail {

template <class F, class Axes, class OtherAxes>
inline constexpr bool has_site_axes =
    std::is_base_of_v<Axes, F> && !std::is_same_v<Axes, F> && !std::is_base_of_v<OtherAxes, F>;

}  // namespace detail

template <class F>
concept EastNorthUpFrame = Frame<F> && detail::has_site_axes<F, east_north_up_frame, north_east_down_frame>;
template <class F>
concept NorthEastDownFrame = Frame<F> && detail::has_site_axes<F, north_east_down_frame, east_north_up_frame>;

namespace detail {

/// The axes of a place, as columns, and the place, in ITRF.
struct SiteNumbers {
  Eigen::Matrix3d axes;
  Eigen::Vector3d position;
};
VECTRIX_EXPORT SiteNumbers east_north_up_site(const Caller& name, const Geodetic& place);
VECTRIX_EXPORT SiteNumbers north_east_down_site(const Caller& name, const Geodetic& place);
template <class S> Caller site_of(const char* action) {
  return {action, [] { return "from<" + frame_name<S>() + ">"; }};
}

template <class F> Transform<earth::Itrf, F> site_transform(const SiteNumbers& site) {
  return {Dcm<earth::Itrf, F>{trusted, site.axes},
          Displacement<earth::Itrf, F, In<earth::Itrf>>{trusted, site.position}};
}

}  // namespace detail

/// The frame of a place on WGS-84, fixed to the Earth: an edge by rigid_edge(east_north_up(from<S>, place)).
/// With latitude phi and longitude lambda the axes are, in ITRF,
///     east (-sin lambda, cos lambda, 0)      up (cos phi cos lambda, cos phi sin lambda, sin phi)
///     north = up x east
/// At a pole, where no direction is east, the given longitude decides: north is along its meridian. Throws
/// BadInput if a number is not finite or |latitude| exceeds pi/2.
template <class S>
std::enable_if_t<EastNorthUpFrame<S>, Transform<earth::Itrf, S>> east_north_up(From<S>,
                                                                               const Geodetic& place) {
  return detail::site_transform<S>(detail::east_north_up_site(detail::site_of<S>("east_north_up"), place));
}
template <class FromFrame, class Place>
auto east_north_up(  // from<S>, Geodetic: struct S : east_north_up_frame
    FromFrame, const Place&) -> Refused = delete;

/// The same with x north, y east, z down.
template <class S>
std::enable_if_t<NorthEastDownFrame<S>, Transform<earth::Itrf, S>> north_east_down(From<S>,
                                                                                   const Geodetic& place) {
  return detail::site_transform<S>(
      detail::north_east_down_site(detail::site_of<S>("north_east_down"), place));
}
template <class FromFrame, class Place>
auto north_east_down(  // from<S>, Geodetic: struct S : north_east_down_frame
    FromFrame, const Place&) -> Refused = delete;

}  // namespace vectrix
