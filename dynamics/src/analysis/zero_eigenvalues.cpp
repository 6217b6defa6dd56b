#include "zero_eigenvalues.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <string>
#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {

Eigen::VectorXd balance(const Eigen::MatrixXd& A) {
  const Eigen::Index n = A.rows();
  Eigen::VectorXd d = Eigen::VectorXd::Ones(n);
  for (bool changed = true; changed;) {
    changed = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      double row = 0.0, column = 0.0;
      for (Eigen::Index j = 0; j < n; ++j) {
        if (j == i) continue;
        row += std::abs(A(i, j)) * d[j] / d[i];
        column += std::abs(A(j, i)) * d[i] / d[j];
      }
      if (!(row > 0.0 && column > 0.0)) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      if (column * factor + row / factor < 0.95 * (column + row)) {  // Parlett and Reinsch 1969
        d[i] *= factor;
        changed = true;
      }
    }
  }
  return d;
}

double largest_singular_value(const Eigen::MatrixXd& A) {
  return A.size() > 0 ? Eigen::JacobiSVD<Eigen::MatrixXd>(A).singularValues()[0] : 0.0;
}

ZerosApart zeros_apart(const Eigen::MatrixXd& A, double least) {
  const Eigen::Index n = A.rows();
  ZerosApart apart{Eigen::MatrixXd::Identity(n, n), A, 0};
  Eigen::Index& k = apart.zeros;
  while (k < n) {
    const Eigen::Index left = n - k;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(apart.T.bottomRightCorner(left, left), Eigen::ComputeFullV);
    const Eigen::Index zeros = (svd.singularValues().array() <= least).count();
    if (zeros == 0) break;
    const Eigen::MatrixXd V = svd.matrixV().rowwise().reverse();  // the null space first
    apart.T.rightCols(left) *= V;
    apart.T.bottomRows(left) = V.transpose() * apart.T.bottomRows(left);
    apart.T.block(k, k, left, zeros).setZero();
    apart.Q.rightCols(left) *= V;
    k += zeros;
  }
  return apart;
}

void require_finite_matrix(const char* action, const char* name, const Eigen::MatrixXd& matrix) {
  if (!matrix.allFinite()) throw BadInput(std::string{action} + ": a number of " + name + " is not finite");
}

std::vector<std::string> names_of_states(const char* action, const LinearSystem& system) {
  std::vector<std::string> names = system.state_names;
  const auto size = static_cast<std::size_t>(system.A.rows());
  if (names.empty())
    for (std::size_t i = 1; i <= size; ++i) names.push_back("x" + text(i));
  if (names.size() != size)
    throw BadInput(std::string{action} + ": A has " + text(size) + " rows, and " + text(names.size()) +
                   " states have names");
  return names;
}

}  // namespace vectrix::detail
