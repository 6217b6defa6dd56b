#pragma once

#include <Eigen/Core>
#include <cmath>

namespace bench {

/// The function on the edges of both graphs: the passive rotation about z.
inline Eigen::Matrix3d spin(double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Eigen::Matrix3d R;
  R << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
  return R;
}

/// The same with its angular velocity, which is constant.
struct Motion {
  Eigen::Matrix3d R;
  Eigen::Vector3d w;
};
inline Motion moving_spin(double angle, const Eigen::Vector3d& w) {
  return {spin(angle), w};
}

}  // namespace bench
