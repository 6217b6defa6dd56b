// A user's program with the compiled library: a decay ydot = -y, once with each family of integrators.
#include <cmath>
#include <vectrix/dynamics.hpp>

int main() {
  using namespace vectrix::ode;
  Problem problem;
  problem.rhs = [](double, double, std::span<const double> y, std::span<double> ydot) { ydot[0] = -y[0]; };
  problem.initial_state = {1.0};
  problem.start = 0.0;
  problem.end = 1.0;
  problem.output_times = {1.0};
  problem.relative_tolerance = 1e-10;
  problem.absolute_tolerances = {1e-12};
  for (const Method method : {Method::cvode_adams, Method::arkode_dormand_prince_5}) {
    problem.method = method;
    const Solution solution = solve(problem);
    if (std::abs(solution.at(1.0)[0] - std::exp(-1.0)) > 1e-8) {
      return 1;
    }
  }
  return 0;
}
