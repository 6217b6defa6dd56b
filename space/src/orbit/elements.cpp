#include <cmath>
#include <numbers>

#include <vectrix/space/orbit/elements.hpp>

#include "conic.hpp"

namespace vectrix {

Quantity<si::length> semi_latus_rectum(const Quantity<si::length>& semi_major_axis, double eccentricity) {
  const double p = semi_major_axis.value() * (1.0 - eccentricity) * (1.0 + eccentricity);
  if (!(p > 0.0 && std::isfinite(p)))
    throw BadInput("semi_latus_rectum: a (1 - e^2) is " + detail::text(p) +
                   " m; it must be finite and positive");
  return p * si::metre;
}

namespace detail {

KeplerianNumbers checked_keplerian(const Caller& name, const KeplerianNumbers& x) {
  require_positive(name, "the semi-latus rectum", x.semi_latus_rectum, " m");
  if (!(x.eccentricity >= 0.0 && std::isfinite(x.eccentricity)))
    throw BadInput(name() + "the eccentricity is " + text(x.eccentricity) +
                   "; it must be finite and not negative");
  if (!(x.inclination >= 0.0 && x.inclination <= std::numbers::pi))
    throw BadInput(name() + "the inclination is " + text(x.inclination) + " rad, not in [0, pi]");
  for (const double angle : {x.ascending_node, x.argument_of_periapsis, x.true_anomaly}) {
    if (!std::isfinite(angle)) throw BadInput(name() + "an angle is " + text(angle) + " rad");
  }
  if (!(1.0 + x.eccentricity * std::cos(x.true_anomaly) > 0.0))
    throw BadInput(name() + "the true anomaly is " + text(x.true_anomaly) +
                   " rad, not inside the asymptotes of the orbit");
  return x;
}

// n = (cos Om, sin Om, 0) to the node, m = normal x n; the argument of latitude, w + nu, counts from n to m.
KeplerianNumbers keplerian_of(const Caller& name, double mu, const OrbitNumbers& orbit) {
  const Conic conic = conic_of(name, mu, orbit);
  const Eigen::Vector3d& normal = conic.normal;
  const double tilt = std::hypot(normal.x(), normal.y());
  const Eigen::Vector3d n = tilt > 0.0 ? Eigen::Vector3d(-normal.y() / tilt, normal.x() / tilt, 0.0)
                                       : Eigen::Vector3d(Eigen::Vector3d::UnitX());
  const double latitude = std::atan2(orbit.r.dot(normal.cross(n)), orbit.r.dot(n));
  const double e = std::hypot(conic.e_cos_nu, conic.e_sin_nu);
  const double nu = e > 0.0 ? std::atan2(conic.e_sin_nu, conic.e_cos_nu) : latitude;
  return {conic.p,
          e,
          std::atan2(tilt, normal.z()),
          std::atan2(n.y(), n.x()),
          std::remainder(latitude - nu, 2.0 * std::numbers::pi),
          nu};
}

Eigen::Matrix3d perifocal_axes(const KeplerianNumbers& x) {
  const double cos_node = std::cos(x.ascending_node), sin_node = std::sin(x.ascending_node);
  const double cos_i = std::cos(x.inclination), sin_i = std::sin(x.inclination);
  const double cos_w = std::cos(x.argument_of_periapsis), sin_w = std::sin(x.argument_of_periapsis);
  const Eigen::Vector3d n(cos_node, sin_node, 0.0), m(-sin_node * cos_i, cos_node * cos_i, sin_i);
  Eigen::Matrix3d axes;
  axes << cos_w * n + sin_w * m, cos_w * m - sin_w * n,
      Eigen::Vector3d(sin_node * sin_i, -cos_node * sin_i, cos_i);
  return axes;
}

OrbitNumbers orbit_of_keplerian(const Caller& name, double mu, const KeplerianNumbers& x) {
  const double e = x.eccentricity, c = std::cos(x.true_anomaly), s = std::sin(x.true_anomaly);
  const Eigen::Matrix3d axes = perifocal_axes(x);
  return in_space(name, mu, x.semi_latus_rectum, {x.semi_latus_rectum / (1.0 + e * c), c, s, -s, e + c},
                  axes.col(0), axes.col(1));
}

}  // namespace detail
}  // namespace vectrix
