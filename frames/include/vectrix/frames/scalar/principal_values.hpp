#pragma once

#include <Eigen/Core>
#include <Eigen/Jacobi>
#include <algorithm>
#include <array>

namespace vectrix::detail {

/// The eigenvalues of a symmetric 3x3 matrix of finite numbers, of which it reads the lower half, in
/// increasing order, by Jacobi's method: each rotation makes one entry off the diagonal zero, and the sum of
/// their squares smaller (Golub and Van Loan, Matrix Computations, section 8.5). Eigen's own solver comes in
/// one header with those of all other matrices, which every file of a user would compile.
template <class S> Eigen::Matrix<S, 3, 1> principal_values(const Eigen::Matrix<S, 3, 3>& symmetric) {
  // Convergence is quadratic: after five sweeps the entries off the diagonal are zero to rounding.
  constexpr int sweeps = 8;
  const S scale = symmetric.cwiseAbs().maxCoeff();
  if (!(scale > S(0))) return Eigen::Matrix<S, 3, 1>::Zero();
  Eigen::Matrix<S, 3, 3> A = symmetric.template selfadjointView<Eigen::Lower>();
  A /= scale;  // its squares do not overflow
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const auto& [p, q] : std::array<std::array<int, 2>, 3>{{{0, 1}, {0, 2}, {1, 2}}}) {
      Eigen::JacobiRotation<S> rotation;
      if (!rotation.makeJacobi(A, p, q)) continue;
      A.applyOnTheLeft(p, q, rotation.adjoint());
      A.applyOnTheRight(p, q, rotation);
    }
  }
  Eigen::Matrix<S, 3, 1> values = scale * A.diagonal();
  std::sort(values.data(), values.data() + 3);
  return values;
}

}  // namespace vectrix::detail
