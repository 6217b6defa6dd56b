#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>
#include <vectrix/dynamics/analysis/linear_system.hpp>

namespace vectrix::detail {

/// The diagonal of D for which rows and columns of D^-1 A D have similar sizes: powers of 2, so that nothing
/// is rounded.
Eigen::VectorXd balance(const Eigen::MatrixXd& A);

/// Q^T A Q = [N X; 0 B] with all zero eigenvalues of A in the nilpotent N. Singular values up to `least` are
/// zero.
struct ZerosApart {
  Eigen::MatrixXd Q, T;
  Eigen::Index zeros;
};
ZerosApart zeros_apart(const Eigen::MatrixXd& A, double least);

double largest_singular_value(const Eigen::MatrixXd& A);

void require_finite_matrix(const char* action, const char* name, const Eigen::MatrixXd& matrix);

/// Of each state; x1, x2, ... if the system has no names. BadInput if it has another number of them.
std::vector<std::string> names_of_states(const char* action, const LinearSystem& system);

}  // namespace vectrix::detail
