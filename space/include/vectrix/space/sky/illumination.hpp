#pragma once

#include <Eigen/Core>

#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/sky/bodies.hpp>

namespace vectrix {
namespace detail {

VECTRIX_EXPORT double visible_past_sphere(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_body,
                                          double radius, double sun_radius);
VECTRIX_EXPORT double visible_past_ellipsoid(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_centre,
                                             double equatorial, double polar, double sun_radius);

template <class P>
inline constexpr bool is_earth = std::same_as<P, earth::Itrf> || std::same_as<P, earth::Gcrf>;

}  // namespace detail

/// The part of the Sun's disc, or of its image, seen from the point p past the spherical body b: 1 in
/// sunlight, 0 in the umbra, with partial and annular eclipses between. Both discs are caps of the sphere
/// around p:
///     1 - lens(a, b, c) / (2 pi (1 - cos a)),    sin a = R_sun/|r_ps|,  sin b = R_b/|r_pb|
/// c the angle between their centres. To 1e-12 of the disc, which is taken as equally bright, without an
/// atmosphere. Throws BadInput if p is inside b or the Sun, or a radius is not positive.
template <class S, class P, class B, class C>
std::enable_if_t<detail::is_sun<S>, double> visible_sun(
    const Displacement<P, S, In<C>>& r_ps_c, const Displacement<P, B, In<C>>& r_pb_c,
    const Quantity<si::length>& radius_of_b, const Quantity<si::length>& radius_of_sun = sky::sun_radius) {
  return detail::visible_past_sphere(r_ps_c.coordinates(), r_pb_c.coordinates(), radius_of_b.value(),
                                     radius_of_sun.value());
}
template <class... Given>
auto visible_sun(  // (r_ps_c, r_pb_c, radius_of_b): the Sun and a body relative to one point, in one frame
    const Given&...) -> Refused = delete;

namespace wgs84 {

/// The same past the ellipsoid of the Earth, so both lines are expressed in earth::Itrf; the centre of the
/// Earth is the origin of earth::Itrf or earth::Gcrf. The limb is taken as a circle around the centre, of the
/// radius that it has in the plane of p, the centre and the Sun. That errs by 3e-5 of the disc up to
/// geostationary height, 3e-4 at the Moon's distance, and 4e-3 where the Earth is smaller than the Sun.
/// Throws BadInput if p is inside the ellipsoid or the Sun.
template <class S, class P, class Centre>
std::enable_if_t<detail::is_sun<S> && detail::is_earth<Centre>, double> visible_sun(
    const Displacement<P, S, In<earth::Itrf>>& r_ps, const Displacement<P, Centre, In<earth::Itrf>>& r_pe,
    const Quantity<si::length>& radius_of_sun = sky::sun_radius) {
  constexpr double equatorial = semi_major_axis.value();
  return detail::visible_past_ellipsoid(r_ps.coordinates(), r_pe.coordinates(), equatorial,
                                        equatorial * (1.0 - flattening), radius_of_sun.value());
}
template <class... Given>
auto visible_sun(  // (r_ps, r_pe): the Sun and the centre of the Earth relative to one point, in earth::Itrf
    const Given&...) -> Refused = delete;

}  // namespace wgs84
}  // namespace vectrix
