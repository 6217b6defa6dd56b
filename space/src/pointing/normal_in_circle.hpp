#pragma once

#include <Eigen/Core>

namespace vectrix::detail {

/// The probability that a vector of a normal distribution in the plane is no longer than `radius`. The
/// covariance may be singular. To 1e-10.
double normal_in_circle(const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance, double radius);

}  // namespace vectrix::detail
