#pragma once

#include <vectrix/frames/dcm_doors.hpp>

namespace vectrix::detail {

/// The rotation that fits an attitude profile matrix best, and how well it is determined.
template <class S> struct ProfileRotation {
  Square<S> rotation;
  /// sigma_2 + d sigma_3: the second-order loss coefficient of a small turn about the least determined axis.
  S margin;
  /// Orthonormal; the first is the least determined axis, the mean direction of a narrow field.
  Square<S> axes;
};

/// The R that maximises tr(R B^T), by B = U Sigma V^T, R = U diag(1, 1, d) V^T, d = det U det V.
/// Markley, Attitude Determination Using Vector Observations and the Singular Value Decomposition (1988).
template <class S> ProfileRotation<S> profile_rotation(const Square<S>& profile) {
  const Eigen::JacobiSVD<Square<S>> svd(profile, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Square<S>& U = svd.matrixU();
  const Square<S>& V = svd.matrixV();
  const S d = U.determinant() * V.determinant() < S(0) ? S(-1) : S(1);
  return {U * Column<S>(S(1), S(1), d).asDiagonal() * V.transpose(),
          svd.singularValues()(1) + d * svd.singularValues()(2), U};
}

}  // namespace vectrix::detail
