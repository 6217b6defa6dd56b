#include <erfa.h>
#include <erfam.h>

#include <cmath>

#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix::wgs84 {
namespace {

constexpr double semi_major_axis = 6378137.0;  // m
constexpr double flattening = 1.0 / 298.257223563;

// Tolerance for the rounding of |u|^2 of a point on the surface: 1.5e-12 of the semi-major axis is 10
// micrometres.
constexpr double surface_tolerance = 3e-12;

// Maps the ellipsoid to the unit sphere.
Eigen::Vector3d scaled(const Eigen::Vector3d& r) {
  return {r.x() / semi_major_axis, r.y() / semi_major_axis, r.z() / (semi_major_axis * (1.0 - flattening))};
}

}  // namespace

Geodetic geodetic(const Vector<earth::Itrf, si::length>& r_itrf) {
  Eigen::Vector3d r = r_itrf.coordinates();
  if (r.isZero(0.0)) throw BadInput("wgs84::geodetic: the centre of the Earth has no latitude");
  double longitude = 0.0;
  double latitude = 0.0;
  double height = 0.0;
  eraGc2gd(ERFA_WGS84, r.data(), &longitude, &latitude, &height);  // fails only for an unknown ellipsoid
  if (!(std::isfinite(latitude) && std::isfinite(height))) {
    throw BadInput("wgs84::geodetic: a position of |r| = " + detail::text(detail::scaled_norm(r)) +
                   " m is too far out for its latitude and height to be found");
  }
  return {latitude * si::radian, longitude * si::radian, height * si::metre};
}

Vector<earth::Itrf, si::length> position(const Geodetic& geodetic) {
  const double latitude = geodetic.latitude.value();
  if (!(std::abs(latitude) <= ERFA_DPI / 2.0)) {
    throw BadInput("wgs84::position: the latitude " + detail::text(latitude) +
                   " rad is not in [-pi/2, pi/2]");
  }
  Eigen::Vector3d r;
  eraGd2gc(ERFA_WGS84, geodetic.longitude.value(), latitude, geodetic.height.value(), r.data());
  return vector<si::length>(in<earth::Itrf>, r);
}

Vector<earth::Itrf, si::dimensionless> up(const Vector<earth::Itrf, si::length>& r_itrf) {
  const Geodetic g = geodetic(r_itrf);
  const double latitude = g.latitude.value();
  const double longitude = g.longitude.value();
  return vector<si::dimensionless>(
      in<earth::Itrf>, Eigen::Vector3d(std::cos(latitude) * std::cos(longitude),
                                       std::cos(latitude) * std::sin(longitude), std::sin(latitude)));
}

// On the unit sphere: u + t v is nearest to the centre at the point n = u - (u.v / v.v) v. It meets the
// sphere at
//     t = (-u.v - sqrt(v.v (1 - n.n))) / v.v = (u.u - 1) / (-u.v + sqrt(v.v (1 - n.n)))
std::optional<Vector<earth::Itrf, si::length>> first_intersection(
    const Vector<earth::Itrf, si::length>& r_itrf, const Vector<earth::Itrf, si::dimensionless>& d_itrf) {
  const Eigen::Vector3d d = direction(d_itrf).coordinates();
  const Eigen::Vector3d u = scaled(r_itrf.coordinates());
  const Eigen::Vector3d v = scaled(d);
  const double outside = u.squaredNorm() - 1.0;
  if (std::abs(outside) <= surface_tolerance) return r_itrf;
  if (outside < 0.0) {
    throw BadInput(
        "wgs84::first_intersection: the origin lies inside the ellipsoid, at a height of " +
        detail::text(r_itrf.coordinates().isZero(0.0) ? -semi_major_axis : geodetic(r_itrf).height.value()) +
        " m");
  }
  const double approach = -u.dot(v);
  if (approach <= 0.0) return std::nullopt;
  const Eigen::Vector3d nearest = u + (approach / v.squaredNorm()) * v;
  const double depth = 1.0 - nearest.squaredNorm();
  if (depth < 0.0) return std::nullopt;
  const double t = outside / (approach + std::sqrt(v.squaredNorm() * depth));
  return vector<si::length>(in<earth::Itrf>, Eigen::Vector3d(r_itrf.coordinates() + t * d));
}

}  // namespace vectrix::wgs84
