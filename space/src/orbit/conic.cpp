#include "conic.hpp"

#include <cmath>

#include <vectrix/space/orbit/orbit_frames.hpp>

namespace vectrix::detail {

void require_positive(const Caller& name, const char* what, double value, const char* unit) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw BadInput(name() + what + " is " + text(value) + unit + "; it must be finite and positive");
}

Conic conic_of(const Caller& name, double mu, const OrbitNumbers& orbit) {
  require_positive(name, "mu", mu, " m^3/s^2");
  const double r = orbit.r.norm(), v = orbit.v.norm();
  const Eigen::Vector3d h = orbit.r.cross(orbit.v);
  const double momentum = h.norm();
  if (!(momentum > nearly_rectilinear * r * v))
    throw BadInput(name() + "|r| is " + text(r) + " m, |v| " + text(v) +
                   " m/s, and the sine of the angle between them " + text(momentum / (r * v)) +
                   "; rectilinear motion has no orbital plane");
  const double p = momentum * momentum / mu;
  require_positive(name, "the semi-latus rectum", p, " m");
  return {p, h / momentum, p / r - 1.0, momentum * orbit.r.dot(orbit.v) / (mu * r)};
}

OrbitNumbers in_space(const Caller& name, double mu, double p, const PlanarMotion& motion,
                      const Eigen::Vector3d& P, const Eigen::Vector3d& Q) {
  require_positive(name, "mu", mu, " m^3/s^2");
  const double speed = std::sqrt(mu / p);
  const OrbitNumbers orbit{motion.radius * (motion.cosine * P + motion.sine * Q),
                           speed * (motion.x * P + motion.y * Q)};
  if (!(orbit.r.allFinite() && orbit.v.allFinite()))
    throw BadInput(name() + "|r| is " + text(motion.radius) + " m, (mu/p)^1/2 " + text(speed) + " m/s");
  return orbit;
}

}  // namespace vectrix::detail
