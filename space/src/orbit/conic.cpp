#include "conic.hpp"

#include <cmath>
#include <limits>

#include <vectrix/space/orbit/orbit_frames.hpp>

namespace vectrix::detail {
namespace {

// Of |r|, by the rounding of e and nu where e cos nu is nearly -1.
constexpr double largest_error_of_distance = 1e-6;

}  // namespace

void require_positive(const Caller& name, const char* what, double value, const char* unit) {
  if (!(value > 0.0 && std::isfinite(value)))
    throw BadInput(name() + what + " is " + text(value) + unit + "; it must be finite and positive");
}

Conic conic_of(const Caller& name, double mu, const OrbitNumbers& orbit) {
  require_positive(name, "mu", mu, " m^3/s^2");
  const double r = orbit.r.norm(), v = orbit.v.norm();
  const Eigen::Vector3d h = orbit.r.cross(orbit.v);
  const double momentum = h.norm();
  if (!(r > 0.0 && v > 0.0))
    throw BadInput(name() + "|r| is " + text(r) + " m, |v| " + text(v) +
                   " m/s; without both there is no orbital plane");
  if (!(momentum > nearly_rectilinear * r * v))
    throw BadInput(name() + "|r| is " + text(r) + " m, |v| " + text(v) +
                   " m/s, and the sine of the angle between them " + text(momentum / (r * v)) +
                   "; rectilinear motion has no orbital plane");
  const double p = momentum * momentum / mu;
  require_positive(name, "the semi-latus rectum", p, " m");
  const Conic conic{p, h / momentum, p / r - 1.0, momentum * orbit.r.dot(orbit.v) / (mu * r)};
  const double e = std::hypot(conic.e_cos_nu, conic.e_sin_nu);
  const double error = std::numeric_limits<double>::epsilon() * (1.0 + e) * r / p;
  if (!(error <= largest_error_of_distance))
    throw BadInput(name() + "|r| is " + text(r) + " m, the semi-latus rectum " + text(p) +
                   " m: |r| = p/(1 + e cos nu) would come back from the elements with an error of " +
                   text(error) + " of it; keep r and v of an orbit as nearly rectilinear as this");
  return conic;
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
