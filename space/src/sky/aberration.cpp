#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/sky/aberration.hpp>

namespace vectrix::detail {

Eigen::Vector3d aberrated(const Eigen::Vector3d& n, const Eigen::Vector3d& v) {
  constexpr double unit_tolerance = 1e-9;
  if (!(std::abs(n.norm() - 1.0) <= unit_tolerance)) {
    throw BadInput("aberrated(n, v): |n| is " + text(n.norm()) + "; n must be a unit vector");
  }
  const Eigen::Vector3d b = v / speed_of_light.value();
  if (!(b.squaredNorm() < 1.0)) {
    throw BadInput("aberrated(n, v): |v| is " + text(v.norm()) + " m/s; it must be below the speed of light");
  }
  const double inverse_g = std::sqrt(1.0 - b.squaredNorm());
  const double along = n.dot(b);
  const Eigen::Vector3d seen = (inverse_g * n + (1.0 + along / (1.0 + inverse_g)) * b) / (1.0 + along);
  return seen.normalized();
}

}  // namespace vectrix::detail
