#pragma once

#include <Eigen/Core>

namespace vectrix {

/// A rigid body in its principal axes, J1 <= J2 <= J3, and the quantities on which its torque-free motion
/// depends. All numbers, also small ones, are accurate to the last digits of long double: they are computed
/// with 34 digits.
struct PrincipalBody {
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;

  Eigen::Matrix<Real, 3, 3> axes;  ///< R_p^b: column i is the i-th principal axis; right-handed
  Vector moments;
  Real J21, J32, J31;  ///< J2 - J1, J3 - J2, J3 - J1
  Vector rate;         ///< w^p
  Real momentum;       ///< H = |J w|
  /// H^2 - 2 T J_i|, zero for a spin about axis i; and whether H^2 - 2 T J2 is negative.
  Vector distance;
  bool nearer_first;
  bool steady;  ///< w x J w = 0: the rate does not change
};

/// The eigenvalue problem of a symmetric tensor.
PrincipalBody principal_body(const Eigen::Matrix3d& J_b, const Eigen::Vector3d& w_b);

}  // namespace vectrix
