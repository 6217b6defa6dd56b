#include <vectrix/dynamics/analysis/controllability.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <vectrix/frames/errors.hpp>

#include "zero_eigenvalues.hpp"

namespace vectrix {
namespace {

/// The same combinations, each with the factor 1 for a coordinate that none of the others has.
Eigen::MatrixXd reduced(Eigen::MatrixXd rows) {
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    Eigen::Index row = 0, column = 0;
    rows.bottomRows(rows.rows() - k).cwiseAbs().maxCoeff(&row, &column);
    rows.row(k).swap(rows.row(k + row));
    rows.row(k) /= double{rows(k, column)};
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      if (i != k) rows.row(i) -= double{rows(i, column)} * rows.row(k);
  }
  return rows;
}

}  // namespace

Controllability controllability(const LinearSystem& system, double tolerance) {
  const Eigen::Index n = system.A.rows();
  if (n != system.A.cols() || n != system.B.rows())
    throw BadInput("controllability: A is " + detail::text(n) + " by " + detail::text(system.A.cols()) +
                   ", B has " + detail::text(system.B.rows()) + " rows");
  if (!(tolerance > 0.0 && tolerance < 1.0))
    throw BadInput("controllability: the tolerance is " + detail::text(tolerance) + "; it must be in (0, 1)");
  detail::require_finite_matrix("controllability", "A", system.A);
  detail::require_finite_matrix("controllability", "B", system.B);
  const Eigen::VectorXd d = detail::balance(system.A);
  const auto in_balance = d.cwiseInverse().asDiagonal();
  Eigen::MatrixXd T = in_balance * system.A * d.asDiagonal();
  const double size = detail::largest_singular_value(T);
  if (size > 0.0) T /= size;
  Eigen::MatrixXd moved = in_balance * system.B;
  for (Eigen::Index i = 0; i < moved.cols(); ++i)
    if (const double norm = moved.col(i).norm(); norm > 0.0) moved.col(i) /= norm;

  Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(n, n);
  Eigen::Index reached = 0;
  while (reached < n && moved.cols() > 0) {
    const Eigen::Index left = n - reached;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(moved, Eigen::ComputeFullU);
    const Eigen::Index rank = (svd.singularValues().array() > tolerance).count();
    if (rank == 0) break;
    const Eigen::MatrixXd& U = svd.matrixU();
    T.rightCols(left) *= U;
    T.bottomRows(left) = U.transpose() * T.bottomRows(left);
    Q.rightCols(left) *= U;
    moved = T.block(reached + rank, reached, left - rank, rank);
    reached += rank;
  }
  const Eigen::Index left = n - reached;
  Controllability found{static_cast<std::size_t>(reached),
                        static_cast<std::size_t>(n),
                        reduced(Q.rightCols(left).transpose() * in_balance),
                        {},
                        detail::names_of_states("controllability", system)};
  const detail::ZerosApart apart =
      detail::zeros_apart(T.bottomRightCorner(left, left) * size, tolerance * size);
  found.unmoved_eigenvalues.assign(static_cast<std::size_t>(apart.zeros), 0.0);
  if (const Eigen::Index other = left - apart.zeros; other > 0) {
    const Eigen::VectorXcd eigenvalues = apart.T.bottomRightCorner(other, other).eigenvalues();
    found.unmoved_eigenvalues.insert(found.unmoved_eigenvalues.end(), eigenvalues.begin(), eigenvalues.end());
  }
  return found;
}

std::ostream& operator<<(std::ostream& out, const Controllability& found) {
  std::ostringstream text;
  text << std::setprecision(3) << found.controllable << " of " << found.size << " states are controllable\n";
  for (Eigen::Index k = 0; k < found.unmoved.rows(); ++k) {
    text << "no input moves";
    const char* before = " ";
    for (Eigen::Index i = 0; i < found.unmoved.cols(); ++i) {
      const double factor = found.unmoved(k, i);
      if (std::abs(factor) < 1e-6) continue;
      text << before << factor << " (" << found.state_names.at(static_cast<std::size_t>(i)) << ')';
      before = " + ";
    }
    text << '\n';
  }
  return out << text.str();
}

}  // namespace vectrix
