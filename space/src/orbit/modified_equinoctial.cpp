#include <cmath>

#include <vectrix/space/orbit/modified_equinoctial.hpp>

#include "conic.hpp"

namespace vectrix::detail {
namespace {

// The axes in the plane of the orbit from which L counts (Broucke and Cefola, On the equinoctial orbit
// elements, 1972).
struct EquinoctialAxes {
  Eigen::Vector3d f, g;

  EquinoctialAxes(double factor, double h, double k)
      : f(1.0 + h * h - k * k, 2.0 * h * k, -2.0 * factor * k),
        g(factor * 2.0 * h * k, factor * (1.0 - h * h + k * k), 2.0 * h) {
    const double size = 1.0 + h * h + k * k;
    f /= size;
    g /= size;
  }
};

}  // namespace

EquinoctialNumbers checked_equinoctial(const Caller& name, const EquinoctialNumbers& x) {
  require_positive(name, "the semi-latus rectum", x.p, " m");
  for (const double number : {x.f, x.g, x.h, x.k, x.L}) {
    if (!std::isfinite(number)) throw BadInput(name() + "an element is " + text(number));
  }
  const double radial = 1.0 + x.f * std::cos(x.L) + x.g * std::sin(x.L);
  if (!(radial > 0.0))
    throw BadInput(name() + "1 + f cos L + g sin L is " + text(radial) +
                   ": the true longitude is not inside the asymptotes of the orbit");
  return x;
}

// tan^I(i/2) (cos Om, sin Om) = (-normal_y, normal_x)/(1 + I normal_z)
EquinoctialNumbers equinoctial_of(const Caller& name, int factor, double mu, const OrbitNumbers& orbit) {
  const Conic conic = conic_of(name, mu, orbit);
  const Eigen::Vector3d& normal = conic.normal;
  const double z = factor * normal.z();
  const double tilt2 = normal.x() * normal.x() + normal.y() * normal.y();
  const double away = z > 0.0 ? 1.0 + z : tilt2 / (1.0 - z);
  if (!(away > 0.0))
    throw BadInput(name() + "the inclination is " + (factor > 0 ? "pi" : "0") + ": a singularity of " +
                   (factor > 0 ? "prograde" : "retrograde") + " elements");
  const double h = -normal.y() / away, k = normal.x() / away;
  const EquinoctialAxes axes(factor, h, k);
  const double L = std::atan2(orbit.r.dot(axes.g), orbit.r.dot(axes.f));
  const double c = std::cos(L), s = std::sin(L);
  return {conic.p, conic.e_cos_nu * c + conic.e_sin_nu * s, conic.e_cos_nu * s - conic.e_sin_nu * c, h, k, L};
}

OrbitNumbers orbit_of_equinoctial(const Caller& name, int factor, double mu, const EquinoctialNumbers& x) {
  const EquinoctialAxes axes(factor, x.h, x.k);
  const double c = std::cos(x.L), s = std::sin(x.L);
  return in_space(name, mu, x.p, {x.p / (1.0 + x.f * c + x.g * s), c, s, -(x.g + s), x.f + c}, axes.f,
                  axes.g);
}

}  // namespace vectrix::detail
