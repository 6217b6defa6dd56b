#pragma once

#include <Eigen/Core>
#include <vector>

namespace bench {

// Moments (1, 2, 3) kg m^2, 100 s at about 1.1 rad/s, not near a principal axis.
inline const Eigen::Vector3d moments(1.0, 2.0, 3.0);
inline const Eigen::Vector3d start_rate(0.7, 0.6, 0.6);
inline const std::vector<double> sample_times{20.0, 40.0, 60.0, 80.0, 100.0};

using Attitudes = std::vector<Eigen::Matrix3d>;  // R_i_from_b at the sample times

/// Euler's equation and the quaternion's by the classical Runge-Kutta method in long double. It shares no
/// code with the library or with Simbody. Its own error is found by halving the step.
Attitudes reference(int steps_per_second);

/// The largest angle between two lists of attitudes, rad.
double difference(const Attitudes& left, const Attitudes& right);

}  // namespace bench
