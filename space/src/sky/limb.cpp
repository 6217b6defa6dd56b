#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/sky/limb.hpp>

namespace vectrix::detail {

double angular_radius(const char* what, const Eigen::Vector3d& to_body, double radius) {
  const double distance = to_body.norm();
  if (!(radius > 0.0 && distance >= radius && std::isfinite(distance))) {
    throw BadInput(std::string{what} + ", of radius " + text(radius) + " m, is " + text(distance) +
                   " m away");
  }
  return std::asin(radius / distance);
}

// Along u = cos(t) n + sin(t) p, where n is to the centre and p across, a tangent from s obeys (u.As)^2 =
// (u.Au)(s.As - 1), A = diag(1/a^2, 1/a^2, 1/b^2), which is a quadratic equation for cot(t).
double angular_radius_towards(const char* what, const Eigen::Vector3d& direction,
                              const Eigen::Vector3d& to_centre, double equatorial, double polar) {
  const Eigen::Vector3d A = Eigen::Vector3d(equatorial, equatorial, polar).cwiseAbs2().cwiseInverse();
  const double distance = to_centre.norm();
  const Eigen::Vector3d As = -A.cwiseProduct(to_centre);
  const double outside = -to_centre.dot(As) - 1.0;
  if (!(outside >= 0.0 && std::isfinite(distance))) {
    throw BadInput(std::string{what} + ": the point is inside the ellipsoid, " + text(distance) +
                   " m from its centre");
  }
  const Eigen::Vector3d n = to_centre / distance;
  const Eigen::Vector3d across = n.cross(direction.cross(n));  // of any length it is normal to n
  // Towards the centre every plane will do.
  const Eigen::Vector3d p =
      across.isZero(0.0) ? n.unitOrthogonal() : Eigen::Vector3d(across.stableNormalized());
  const double pAs = p.dot(As);
  const double pAp = p.dot(A.cwiseProduct(p));
  const double root = std::sqrt(outside * ((outside + 1.0) * pAp - pAs * pAs));
  return std::atan2(outside + 1.0, distance * (pAs + root));
}

}  // namespace vectrix::detail
