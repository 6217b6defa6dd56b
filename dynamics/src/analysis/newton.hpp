#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace vectrix::detail {

/// F(x) = 0 with Newton's method and line search (KINSOL). Rows and columns of the Jacobian may depend on
/// each other: each step is the shortest in x/size of those that bring F/tolerance nearest to zero.
struct NewtonProblem {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& x)> function;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& x)> jacobian;
  Eigen::VectorXd start, size, tolerance;
};
struct NewtonResult {
  Eigen::VectorXd x;
  long iterations;
  std::string flag;  ///< of KINSOL
};
/// Where it ends; whether F is below its tolerance there, the caller sees. What a function throws is thrown.
NewtonResult newton(const NewtonProblem& problem);

}  // namespace vectrix::detail
