#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>

#include <vectrix/space/earth/ellipsoid.hpp>

#include "ellipsoid_normal.hpp"
#include "require_geodetic.hpp"

namespace vectrix::wgs84 {
namespace {

using detail::equatorial_axis, detail::polar_axis;

// Tolerance for the rounding of |u|^2 of a point on the surface: 1.5e-12 of the semi-major axis is 10
// micrometres.
constexpr double surface_tolerance = 3e-12;

// Maps the ellipsoid to the unit sphere.
Eigen::Vector3d scaled(const Eigen::Vector3d& r) {
  return {r.x() / equatorial_axis, r.y() / equatorial_axis, r.z() / polar_axis};
}

using Real = long double;

// The meridian through the position: the distance from the axis, and the height over the equator.
struct OnMeridian {
  Real R, z;
};

OnMeridian on_meridian(const Eigen::Vector3d& r) {
  return {std::sqrt(Real{r.x()} * r.x() + Real{r.y()} * r.y()), r.z()};
}

constexpr Real e2 = Real{flattening} * (2 - Real{flattening});

// The direction (cosine, sine) of the normal, of any length, and the height.
struct Normal {
  Real cosine, sine, height;
};

// Outside the ellipsoid. With the reduced latitude u of the nearest point,
//     tan phi = (z + e'^2 b sin^3 u) / (R - e^2 a cos^3 u),    tan u = (1 - f) tan phi
// (Bowring, Transformation from spatial to geographical coordinates, 1976), from his first value, u of
// tan u = (z b / (R a)) (1 + e'^2 b / r). Twice: 3e-13 rad after one step, nothing left after two.
Normal nearest_from_outside(const OnMeridian& at) {
  constexpr Real a = equatorial_axis, shorter = 1 - Real{flattening}, b = a * shorter,
                 second_e2 = e2 / (1 - e2);
  Real sine = at.z * shorter * (1 + second_e2 * b / std::sqrt(at.R * at.R + at.z * at.z)), cosine = at.R;
  for (int step = 0; step < 2; ++step) {
    const Real scale = 1 / std::sqrt(sine * sine + cosine * cosine);
    const Real sine_u = scale * sine, cosine_u = scale * cosine;
    sine = at.z + second_e2 * b * sine_u * sine_u * sine_u;
    cosine = at.R - e2 * a * cosine_u * cosine_u * cosine_u;
    if (step == 0) sine *= shorter;
  }
  const Real scale = 1 / std::sqrt(sine * sine + cosine * cosine);
  const Real sine_phi = scale * sine;
  return {cosine, sine,
          scale * cosine * at.R + sine_phi * at.z - a * std::sqrt(1 - e2 * sine_phi * sine_phi)};
}

// Inside it, on the surface and outside too. The normal of the ellipse through the point (R, z), R >= 0, from
// the nearest point of the ellipse. With k the positive root of
//     k^4 + 2 e^2 k^3 - (p + q - e^4) k^2 - 2 e^2 q k - e^4 q = 0,    p = (R/a)^2, q = (1 - e^2) (z/a)^2
// the normal has the direction (R / (k + e^2), z / k). The quartic by its resolvent cubic, without
// cancellation (Karney, Geodesics on an ellipsoid of revolution, 2011, appendix B).
Normal nearest_from_inside(const OnMeridian& at) {
  const auto [R, z] = at;
  constexpr Real a = equatorial_axis;
  constexpr Real e4 = e2 * e2;
  const Real p = (R / a) * (R / a);
  const Real q = (1 - e2) * (z / a) * (z / a);
  const Real r = (p + q - e4) / 6;
  if (e4 * q == 0 && r <= 0) {
    // In the equatorial disc around the centre, k = 0. Of two nearest points the northern one.
    const Real sine = std::sqrt((e4 - p) / (1 - e2)), cosine = std::sqrt(p);
    return {cosine, sine, -a * (1 - e2) * std::hypot(sine, cosine) / e2};
  }
  const Real S = e4 * p * q / 4;
  const Real cube = r * r * r;
  const Real discriminant = S * (2 * cube + S);
  Real u = r;
  if (discriminant >= 0) {
    const Real sum = S + cube;
    const Real root = std::cbrt(sum + std::copysign(std::sqrt(discriminant), sum));
    if (root != 0) u += root + r * r / root;
  } else {
    u += 2 * r * std::cos(std::atan2(std::sqrt(-discriminant), -(S + cube)) / 3);
  }
  const Real v = std::sqrt(u * u + e4 * q);
  const Real uv = u < 0 ? e4 * q / (v - u) : u + v;
  const Real w = std::max(Real{0}, e2 * (uv - q) / (2 * v));
  const Real k = uv / (std::sqrt(uv + w * w) + w);
  return {R / (k + e2), z / k, (1 - (1 - e2) / k) * std::hypot(k * R / (k + e2), z)};
}

Normal nearest(const Eigen::Vector3d& r) {
  const bool outside = scaled(r).squaredNorm() >= 1.0;
  return outside ? nearest_from_outside(on_meridian(r)) : nearest_from_inside(on_meridian(r));
}

}  // namespace

Geodetic geodetic(const earth::PositionInItrf& r_itrf) {
  const Eigen::Vector3d r = r_itrf.coordinates();
  detail::require_place({"wgs84::geodetic"}, r);
  const double longitude = detail::longitude_of(r);
  const Normal normal = nearest(r);
  const double latitude = std::atan2(static_cast<double>(normal.sine), static_cast<double>(normal.cosine));
  return {GeodeticLatitude(latitude * si::radian), longitude * si::radian,
          static_cast<double>(normal.height) * si::metre};
}

Vector<earth::Itrf, si::length> position(const Geodetic& geodetic) {
  detail::require_geodetic({"wgs84::position"}, geodetic);
  Eigen::Vector3d r;
  eraGd2gc(ERFA_WGS84, geodetic.longitude.value(), geodetic.latitude.angle.value(), geodetic.height.value(),
           r.data());
  return vector<si::length>(in<earth::Itrf>, r);
}

Vector<earth::Itrf, si::dimensionless> up(const earth::PositionInItrf& r_itrf) {
  return {detail::trusted, detail::normal_at({"wgs84::up"}, r_itrf.coordinates()).up};
}

// On the unit sphere: u + t v is nearest to the centre at the point n = u - (u.v / v.v) v. It meets the
// sphere at
//     t = (-u.v - sqrt(v.v (1 - n.n))) / v.v = (u.u - 1) / (-u.v + sqrt(v.v (1 - n.n)))
std::optional<Vector<earth::Itrf, si::length>> first_intersection(
    const earth::PositionInItrf& r_itrf, const Vector<earth::Itrf, si::dimensionless>& d_itrf) {
  const Eigen::Vector3d d = direction(d_itrf).coordinates();
  const Eigen::Vector3d u = scaled(r_itrf.coordinates());
  const Eigen::Vector3d v = scaled(d);
  const double outside = u.squaredNorm() - 1.0;
  if (!std::isfinite(outside))
    throw BadInput("wgs84::first_intersection: |r| is " + detail::text(r_itrf.coordinates().stableNorm()) +
                   " m; the origin is too far");
  if (std::abs(outside) <= surface_tolerance)
    return vector<si::length>(in<earth::Itrf>, r_itrf.coordinates());
  if (outside < 0.0) {
    throw BadInput("wgs84::first_intersection: the origin lies inside the ellipsoid, at a height of " +
                   detail::text(static_cast<double>(nearest(r_itrf.coordinates()).height)) + " m");
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

namespace vectrix::detail {

EllipsoidNormal normal_at(const Caller& name, const Eigen::Vector3d& r) {
  require_place(name, r);
  const auto [cosine, sine, height] = wgs84::nearest(r);
  const double from_axis = std::hypot(r.x(), r.y());
  const Eigen::Vector2d outward =
      from_axis > 0.0 ? Eigen::Vector2d(r.head<2>() / from_axis) : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  const wgs84::Real length = std::sqrt(cosine * cosine + sine * sine);
  const auto c = static_cast<double>(cosine / length), s = static_cast<double>(sine / length);
  return {{c * outward.x(), c * outward.y(), s}, static_cast<double>(height)};
}

}  // namespace vectrix::detail
