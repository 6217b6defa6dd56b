#include <cmath>

#include <vectrix/space/earth/ellipsoid.hpp>

#include "require_geodetic.hpp"

namespace vectrix::earth {

Spherical spherical(const PositionInItrf& r_itrf) {
  const Eigen::Vector3d r = r_itrf.coordinates();
  detail::require_place({"earth::spherical"}, r);
  return {GeocentricLatitude(std::atan2(r.z(), std::hypot(r.x(), r.y())) * si::radian),
          detail::longitude_of(r) * si::radian, std::hypot(r.x(), r.y(), r.z()) * si::metre};
}

Vector<Itrf, si::length> position(const Spherical& spherical) {
  const detail::Caller name{"earth::position"};
  const double latitude = spherical.latitude.angle.value(), longitude = spherical.longitude.value(),
               distance = spherical.distance.value();
  detail::require_angles(name, latitude, longitude);
  if (!(distance >= 0.0 && std::isfinite(distance)))
    throw BadInput(name() + "the distance is " + detail::text(distance) +
                   " m; it must be finite and not negative");
  const double across = distance * std::cos(latitude);
  return vector<si::length>(in<Itrf>,
                            Eigen::Vector3d(across * std::cos(longitude), across * std::sin(longitude),
                                            distance * std::sin(latitude)));
}

}  // namespace vectrix::earth
