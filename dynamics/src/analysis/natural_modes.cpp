#include <vectrix/dynamics/analysis/natural_modes.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <vectrix/frames/errors.hpp>

#include "zero_eigenvalues.hpp"

namespace vectrix {

NaturalModes natural_modes(const LinearSystem& system, double rounding) {
  const Eigen::MatrixXd& A = system.A;
  if (A.rows() != A.cols())
    throw BadInput("natural_modes: A has " + detail::text(A.rows()) + " rows and " + detail::text(A.cols()) +
                   " columns");
  detail::require_finite_matrix("natural_modes", "A", A);
  if (!(rounding > 0.0 && rounding < 1.0))
    throw BadInput("natural_modes: the rounding is " + detail::text(rounding) + "; it must be in (0, 1)");
  const Eigen::VectorXd d = detail::balance(A);
  const Eigen::MatrixXd balanced = d.cwiseInverse().asDiagonal() * A * d.asDiagonal();
  const detail::ZerosApart apart =
      detail::zeros_apart(balanced, rounding * detail::largest_singular_value(balanced));
  const Eigen::Index zeros = apart.zeros, left = A.rows() - zeros;
  NaturalModes modes{{}, static_cast<std::size_t>(zeros), detail::names_of_states("natural_modes", system)};
  if (left == 0) return modes;

  const Eigen::EigenSolver<Eigen::MatrixXd> solver(apart.T.bottomRightCorner(left, left));
  const Eigen::MatrixXcd right = solver.eigenvectors(), inverse = right.inverse();
  for (Eigen::Index i = 0; i < left; ++i) {
    const std::complex<double> lambda = solver.eigenvalues()[i];
    if (lambda.imag() < 0.0) continue;
    // [N X; 0 B] v = lambda v
    const Eigen::VectorXcd driven = apart.T.topRightCorner(zeros, left) * right.col(i);
    Eigen::MatrixXcd shifted = -apart.T.topLeftCorner(zeros, zeros).cast<std::complex<double>>();
    shifted.diagonal().array() += lambda;
    Eigen::VectorXcd v(A.rows()), l = Eigen::VectorXcd::Zero(A.rows());
    v << Eigen::VectorXcd(shifted.partialPivLu().solve(driven)), right.col(i);
    l.tail(left) = inverse.row(i).transpose();
    v = d.asDiagonal() * (apart.Q * v);
    l = d.cwiseInverse().asDiagonal() * (apart.Q * l);
    const Eigen::VectorXd part = v.cwiseProduct(l).cwiseAbs();
    Eigen::Index largest = 0;
    v.cwiseAbs().maxCoeff(&largest);
    const std::complex<double> one = v[largest];
    modes.list.push_back({lambda, Quantity<si::angular_velocity>::from_value(std::abs(lambda)),
                          -lambda.real() / std::abs(lambda), v / one, part / part.sum()});
  }
  std::stable_sort(modes.list.begin(), modes.list.end(),
                   [](const NaturalMode& a, const NaturalMode& b) { return a.frequency < b.frequency; });
  return modes;
}

std::ostream& operator<<(std::ostream& out, const NaturalModes& modes) {
  std::ostringstream text;
  text << std::setprecision(5) << modes.zeros << " zero eigenvalues\n";
  for (const NaturalMode& mode : modes.list) {
    text << mode.frequency.value() << " rad/s, damping ratio "
         << (std::abs(mode.damping_ratio) < 1e-9 ? 0.0 : mode.damping_ratio) << ':';
    const char* before = " ";
    for (Eigen::Index i = 0; i < mode.participation.size(); ++i) {
      if (mode.participation[i] < 0.1) continue;
      text << before << std::lround(100.0 * mode.participation[i]) << " % "
           << modes.state_names.at(static_cast<std::size_t>(i));
      before = ", ";
    }
    text << '\n';
  }
  return out << text.str();
}

}  // namespace vectrix
