#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

namespace vectrix::accuracy {

/// The arithmetic of the references. It represents every double exactly; its rounding is 2048 times finer.
using Wide = long double;
static_assert(std::numeric_limits<Wide>::digits >= 64, "the table is made where long double has 64 digits");

using WideColumn = Eigen::Matrix<Wide, 3, 1>;
using WideSquare = Eigen::Matrix<Wide, 3, 3>;
using WideQuaternion = Eigen::Quaternion<Wide>;
template <int n> using WideMatrix = Eigen::Matrix<Wide, n, n>;

inline constexpr Wide ulps_in_one = 0x1p52L;
inline constexpr Wide pi = std::numbers::pi_v<Wide>;

template <class Derived> auto widened(const Eigen::MatrixBase<Derived>& numbers) {
  return numbers.template cast<Wide>().eval();
}

inline WideSquare skew(const WideColumn& x) {
  WideSquare m;
  m << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return m;
}

/// A + A^2/2! + A^3/3! + ..., and A/2! + A^2/3! + ...: without the first terms, which would round small A.
template <int n> struct Series { WideMatrix<n> exponential, jacobian; };

/// exp(A) - I and its integral J - I, J = I + A/2! + A^2/3! + ..., by their power series. A is halved until
/// it is small:
///     exp(2A) = exp(A)^2        J(2A) = (I + exp(A)) J(A) / 2
template <int n> Series<n> series(const WideMatrix<n>& A) {
  int halvings = 0;
  WideMatrix<n> small = A;
  for (; small.cwiseAbs().maxCoeff() > 0.5L; ++halvings) small /= 2;
  Series<n> sum{WideMatrix<n>::Zero(), WideMatrix<n>::Zero()};
  for (int k = 26; k >= 1; --k) {
    // Horner: A (I + A/2 (I + A/3 (...)))
    sum.exponential = (small + small * sum.exponential) / Wide(k);
    sum.jacobian = (small + small * sum.jacobian) / Wide(k + 1);
  }
  for (; halvings > 0; --halvings) {
    const WideMatrix<n>& E = sum.exponential;
    const WideMatrix<n>& J = sum.jacobian;
    sum = {2 * E + E * E, J + E / 2 + E * J / 2};
  }
  return sum;
}
inline WideSquare exponential(const WideColumn& theta) {
  return WideSquare::Identity() + series<3>(skew(theta)).exponential;
}
inline WideSquare left_jacobian_series(const WideColumn& theta) {
  return WideSquare::Identity() + series<3>(skew(theta)).jacobian;
}

/// Uses pivots: cofactors would lose the digits of a nearly singular matrix.
template <int n> WideMatrix<n> inverse_of(const WideMatrix<n>& A) {
  return A.partialPivLu().inverse();
}

/// The rotation nearest to a matrix, its polar factor, by Newton's iteration.
inline WideSquare nearest_rotation(WideSquare M) {
  M /= std::cbrt(std::abs(M.determinant()));
  for (int i = 0; i < 60; ++i) {
    const WideSquare next = (M + M.inverse().transpose()) / 2;
    const Wide change = (next - M).cwiseAbs().maxCoeff();
    M = next;
    if (change < 1e-15L) break;  // convergence is quadratic: the remaining error is its square
  }
  return M;
}

/// The quaternion of R, of either sign, from the longest row of 4 q q^T: without division by a component.
inline WideQuaternion quaternion_of(const WideSquare& R) {
  Eigen::Matrix<Wide, 4, 4> K;  // scalar last
  const Wide trace = R.trace();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) K(i, j) = R(i, j) + R(j, i) + (i == j ? 1 - trace : 0);
    K(i, 3) = K(3, i) = R((i + 2) % 3, (i + 1) % 3) - R((i + 1) % 3, (i + 2) % 3);
  }
  K(3, 3) = 1 + trace;
  Eigen::Index longest = 0;
  K.rowwise().squaredNorm().maxCoeff(&longest);
  const Eigen::Matrix<Wide, 4, 1> q = K.row(longest).transpose();
  return WideQuaternion(Eigen::Matrix<Wide, 4, 1>(q / q.norm()));
}
inline WideSquare rotation_of(const WideQuaternion& q) {
  return q.normalized().toRotationMatrix();
}

/// The rotation vector of the shortest turn of a quaternion of any length and sign. At half a turn, one of
/// the two.
inline WideColumn rotation_vector_of(const WideQuaternion& q) {
  const Wide largest = q.vec().cwiseAbs().maxCoeff();
  if (largest == 0) return WideColumn::Zero();
  const WideColumn direction = (q.vec() / largest).normalized();
  const Wide length = largest * (q.vec() / largest).norm();
  const Wide angle = 2 * std::atan2(length, std::abs(q.w()));
  return (q.w() < 0 ? -angle : angle) * direction;
}
inline WideColumn rotation_vector_of(const WideSquare& R) {
  return rotation_vector_of(quaternion_of(R));
}

/// The angle between two rotations, rad.
inline Wide turn_between(const WideSquare& first, const WideSquare& second) {
  return rotation_vector_of(nearest_rotation(first.transpose() * second)).norm();
}

}  // namespace vectrix::accuracy
