#pragma once

#include <Eigen/Core>

#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix {
namespace detail {

/// Of a sphere. `what` begins the error.
VECTRIX_EXPORT double angular_radius(const char* what, const Eigen::Vector3d& to_body, double radius);
/// Of an ellipsoid of revolution, from its centre to its limb, in the plane of the centre and a direction, on
/// the side of the direction.
VECTRIX_EXPORT double angular_radius_towards(const char* what, const Eigen::Vector3d& direction,
                                             const Eigen::Vector3d& to_centre, double equatorial,
                                             double polar);

}  // namespace detail

/// The angle under which the radius of the spherical body b is seen from p: asin(R/|r_pb|). Throws BadInput
/// if p is inside b, or the radius is not positive.
template <class P, class B, class C>
Quantity<si::angle> angular_radius(const Displacement<P, B, In<C>>& r_pb_c,
                                   const Quantity<si::length>& radius) {
  return detail::angular_radius("angular_radius: the body", r_pb_c.coordinates(), radius.value()) *
         si::radian;
}

/// How far the direction n, a vector or a displacement from p, is beside the limb of the spherical body b:
///     angle_between(n, r_pb) - asin(R/|r_pb|)
/// negative on the disc. Smooth across the limb, so events() finds when a boresight enters a keep-out zone:
///     const auto beside = [&](const Epoch& t) { return angle_from_limb(n(t), to_sun(t), sky::sun_radius); };
///     events(span, step, [&](const Epoch& t) { return beside(t) - least; })
/// Throws BadInput if p is inside b, the radius is not positive, or n is zero.
template <class Direction, class P, class B, class C>
std::enable_if_t<detail::HasAngle<Direction, Displacement<P, B, In<C>>>, Quantity<si::angle>> angle_from_limb(
    const Direction& n_c, const Displacement<P, B, In<C>>& r_pb_c, const Quantity<si::length>& radius) {
  const double limb =
      detail::angular_radius("angle_from_limb: the body", r_pb_c.coordinates(), radius.value());
  return angle_between(n_c, r_pb_c) - limb * si::radian;
}
template <class... Given>
auto angle_from_limb(  // (n_c, r_pb_c, radius_of_b): a direction, and a body relative to p, in one frame
    const Given&...) -> Refused = delete;

namespace wgs84 {

/// The same for the ellipsoid of the Earth, in the plane of n and the centre of the Earth: zero if the line
/// from p along n touches the ellipsoid, and up to 80 deg beside it within 1e-3 deg of the angle to the
/// nearest point of the limb, 2e-3 deg if p is near the ground. The atmosphere is left out. Throws BadInput
/// if p is inside the ellipsoid, or n is zero.
template <class Direction, class P, class Centre>
  requires(detail::is_earth<Centre>&& detail::HasAngle<Direction, Displacement<P, Centre, In<earth::Itrf>>>)
Quantity<si::angle> angle_from_limb(const Direction& n,
                                    const Displacement<P, Centre, In<earth::Itrf>>& r_pe) {
  constexpr double equatorial = semi_major_axis.value();
  const double limb =
      detail::angular_radius_towards("angle_from_limb", detail::plain(n).coordinates(), r_pe.coordinates(),
                                     equatorial, equatorial * (1.0 - flattening));
  return angle_between(n, r_pe) - limb * si::radian;
}
template <class... Given>
auto angle_from_limb(  // (n, r_pe): a direction, and the centre of the Earth relative to p, in earth::Itrf
    const Given&...) -> Refused = delete;

}  // namespace wgs84
}  // namespace vectrix
