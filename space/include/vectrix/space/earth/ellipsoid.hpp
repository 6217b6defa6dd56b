#pragma once

#include <optional>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/position_in_itrf.hpp>

namespace vectrix {
namespace detail {
template <class Given> inline constexpr bool no_latitude = false;
}

/// The angle between the equatorial plane and the normal of the ellipsoid, in [-pi/2, pi/2], positive north:
/// the latitude of maps, receivers and surveys. Up to 0.19 deg, 21 km, from the geocentric one.
struct GeodeticLatitude {
  Quantity<si::angle> angle;
  explicit constexpr GeodeticLatitude(const Quantity<si::angle>& latitude) : angle(latitude) {}
  template <class Given> GeodeticLatitude(const Given&) {
    static_assert(detail::no_latitude<Given>, "an angle in rad: GeodeticLatitude(angle)");
  }
  operator Quantity<si::angle>() const = delete;  // the angle of a latitude: latitude.angle
};
/// The angle between the equatorial plane and the line to the centre of the Earth, positive north.
struct GeocentricLatitude {
  Quantity<si::angle> angle;
  explicit constexpr GeocentricLatitude(const Quantity<si::angle>& latitude) : angle(latitude) {}
  template <class Given> GeocentricLatitude(const Given&) {
    static_assert(detail::no_latitude<Given>, "an angle in rad: GeocentricLatitude(angle)");
  }
  operator Quantity<si::angle>() const = delete;  // the angle of a latitude: latitude.angle
};

/// Geodetic coordinates: latitude; longitude in (-pi, pi], positive east; height above the ellipsoid.
struct Geodetic {
  GeodeticLatitude latitude;
  Quantity<si::angle> longitude;
  Quantity<si::length> height;
};

namespace earth {

/// Spherical coordinates in ITRF: geocentric latitude, longitude as in Geodetic, distance from the centre.
struct Spherical {
  GeocentricLatitude latitude;
  Quantity<si::angle> longitude;
  Quantity<si::length> distance;
};
/// On the axis the longitude is 0. Throws BadInput for the centre of the Earth and what is not finite.
VECTRIX_EXPORT Spherical spherical(const PositionInItrf& r_itrf);
/// The inverse. Throws BadInput if a number is not finite, |latitude| exceeds pi/2, or the distance is
/// negative. The way to the geodetic latitude: wgs84::geodetic(earth::position(spherical)).
VECTRIX_EXPORT Vector<Itrf, si::length> position(const Spherical& spherical);

}  // namespace earth

/// The reference ellipsoid WGS-84: semi-major axis a = 6378137 m, flattening 1/298.257223563.
namespace wgs84 {

inline constexpr Quantity<si::length> semi_major_axis = 6378137.0 * si::metre;
inline constexpr double flattening = 1.0 / 298.257223563;

/// The nearest point of the ellipsoid, and the height above it: to rounding at every height and depth. On the
/// axis the longitude is 0. On the evolute, within 43 km of the centre, several points are nearest; across
/// the equatorial disc inside it the latitude jumps from north to south, and on the disc it is the northern
/// one. Throws BadInput for the centre of the Earth, which has no latitude, and for what is not finite or too
/// far to be squared.
VECTRIX_EXPORT Geodetic geodetic(const earth::PositionInItrf& r_itrf);

/// The inverse. Throws BadInput if a number is not finite or |latitude| exceeds pi/2.
VECTRIX_EXPORT Vector<earth::Itrf, si::length> position(const Geodetic& geodetic);

/// The unit normal of the ellipsoid at the latitude and longitude of r; it points up. Throws BadInput for the
/// centre of the Earth.
VECTRIX_EXPORT Vector<earth::Itrf, si::dimensionless> up(const earth::PositionInItrf& r_itrf);

/// The radii of curvature of the ellipsoid below a place, along the meridian and across it:
///     M = a (1 - e^2) / (1 - e^2 sin^2 phi)^(3/2)       N = a / (1 - e^2 sin^2 phi)^(1/2)
/// with e^2 = f (2 - f). They do not depend on the height. Throws BadInput if a number is not finite or
/// |latitude| exceeds pi/2.
struct RadiiOfCurvature {
  Quantity<si::length> meridian, prime_vertical;
};
VECTRIX_EXPORT RadiiOfCurvature radii_of_curvature(const Geodetic& place);

/// The radius of the normal section in an azimuth, counted from the north over the east (Euler):
///     1/R = cos^2(azimuth) / M + sin^2(azimuth) / N
/// Throws BadInput if the azimuth is not finite, or as radii_of_curvature().
VECTRIX_EXPORT Quantity<si::length> radius_of_curvature(const Geodetic& place,
                                                        const Quantity<si::angle>& azimuth);

/// The angle by which the horizon of the ellipsoid lies below the horizontal plane, in an azimuth: of the ray
/// that touches the ellipsoid. Without refraction. On a sphere its cosine is R / (R + h). Throws BadInput if
/// the height is negative or a number is not finite, or |latitude| exceeds pi/2.
VECTRIX_EXPORT Quantity<si::angle> horizon_dip(const Geodetic& place, const Quantity<si::angle>& azimuth);

/// The first intersection of the ray r + t d, t >= 0, with the ellipsoid; nothing if there is none. d is any
/// vector but zero. If the origin is within about 10 micrometres of the surface, the result is the origin.
/// Throws BadInput if the origin is inside or too far for its square, or d is zero.
VECTRIX_EXPORT std::optional<Vector<earth::Itrf, si::length>> first_intersection(
    const earth::PositionInItrf& r_itrf, const Vector<earth::Itrf, si::dimensionless>& d_itrf);

}  // namespace wgs84
}  // namespace vectrix
