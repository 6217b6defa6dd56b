#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/frames/scalar/larger.hpp>

#include "methods.hpp"

/// Problems with closed-form solutions, shared by the tests of the integration layer.
namespace vectrix::ode::test {

using State = std::span<const double>;

using vectrix_test::methods;

/// Those of SUNDIALS, whose dense output goes through the nodes.
inline const std::vector<Method> sundials_methods(methods.begin(), methods.begin() + 4);

/// Those that inline the right-hand side.
inline const std::vector<Method> inlined_methods = {Method::verner_9, Method::verner_7};

inline std::string name(const testing::TestParamInfo<Method>& info) {
  return vectrix_test::name_of(info.param);
}

inline void set_tolerance(Problem& problem, double tolerance) {
  problem.relative_tolerance = tolerance;
  problem.absolute_tolerances.assign(problem.initial_state.size(), tolerance);
}

/// x'' = -x, x(0) = 1, x'(0) = 0: y = (cos t, -sin t).
inline Problem oscillator(Method method, double end, double tolerance) {
  Problem problem;
  problem.rhs = [](double, double, State y, std::span<double> ydot) {
    ydot[0] = y[1];
    ydot[1] = -y[0];
  };
  problem.initial_state = {1.0, 0.0};
  problem.start = 0.0;
  problem.end = end;
  problem.method = method;
  set_tolerance(problem, tolerance);
  return problem;
}

inline std::vector<double> oscillator_state(double t) {
  return {std::cos(t), -std::sin(t)};
}

inline double distance(State a, State b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = vectrix::detail::larger(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Largest error of a solution at its nodes.
template <class Exact> double node_error(const Solution& solution, const Exact& exact) {
  EXPECT_GT(solution.node_count(), 1U);
  double largest = 0.0;
  for (std::size_t i = 0; i < solution.node_count(); ++i) {
    largest = vectrix::detail::larger(largest, distance(solution.node(i).y, exact(solution.node(i).t)));
  }
  return largest;
}

}  // namespace vectrix::ode::test
