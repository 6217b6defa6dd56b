#include <cmath>

#include <vectrix/space/earth/ellipsoid.hpp>

#include "ellipsoid_normal.hpp"
#include "require_geodetic.hpp"

namespace vectrix::wgs84 {
namespace {

using detail::Caller, detail::eccentricity_squared, detail::equatorial_axis;

double checked_azimuth(const Caller& name, const Quantity<si::angle>& azimuth) {
  if (!std::isfinite(azimuth.value())) {
    throw BadInput(name() + "the azimuth is " + detail::text(azimuth.value()) + " rad");
  }
  return azimuth.value();
}

RadiiOfCurvature radii(const Caller& name, const Geodetic& place) {
  detail::require_geodetic(name, place);
  const double sine = std::sin(place.latitude.angle.value());
  const double w2 = 1.0 - eccentricity_squared * sine * sine, across = equatorial_axis / std::sqrt(w2);
  return {(1.0 - eccentricity_squared) / w2 * across * si::metre, across * si::metre};
}

}  // namespace

RadiiOfCurvature radii_of_curvature(const Geodetic& place) {
  return radii({"wgs84::radii_of_curvature"}, place);
}

Quantity<si::length> radius_of_curvature(const Geodetic& place, const Quantity<si::angle>& azimuth) {
  const Caller name{"wgs84::radius_of_curvature"};
  const auto both = radii(name, place);
  const double A = checked_azimuth(name, azimuth);
  const double cosine = std::cos(A), sine = std::sin(A);
  return 1.0 / (cosine * cosine / both.meridian.value() + sine * sine / both.prime_vertical.value()) *
         si::metre;
}

// S = diag(1/a, 1/a, 1/b) maps the ellipsoid to the unit sphere, the vertical n to q and the horizontal in
// the azimuth to p; at the foot of the vertical S S r0 = c n. The ray p - tan(dip) q from S r0 + h q touches
// the unit sphere if
//     tan(dip) = (sqrt(h (2c + h q.q) p.p) - h p.q) / c
Quantity<si::angle> horizon_dip(const Geodetic& place, const Quantity<si::angle>& azimuth) {
  const Caller name{"wgs84::horizon_dip"};
  detail::require_geodetic(name, place);
  const double latitude = place.latitude.angle.value(), h = place.height.value();
  const double A = checked_azimuth(name, azimuth);
  if (!(h >= 0.0)) {
    throw BadInput(name() + "the height is " + detail::text(h) + " m; there is no horizon");
  }
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  constexpr double equator = 1.0 / (equatorial_axis * equatorial_axis),
                   pole = equator / (1.0 - eccentricity_squared);  // the squares of S, 1/m^2
  const double across = std::sin(A), along = std::cos(A);
  const double qq = cosine * cosine * equator + sine * sine * pole;
  const double pp =
      along * along * (sine * sine * equator + cosine * cosine * pole) + across * across * equator;
  const double pq = along * sine * cosine * (pole - equator);
  const double c = 1.0 / (equatorial_axis * std::sqrt(1.0 - eccentricity_squared * sine * sine));
  return std::atan((std::sqrt(h * (2.0 * c + h * qq) * pp) - h * pq) / c) * si::radian;
}

}  // namespace vectrix::wgs84
