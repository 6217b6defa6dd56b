#include <vectrix/dynamics/ode/solve.hpp>

#include <utility>

#include "check.hpp"
#include "run.hpp"

namespace vectrix::ode {

Failure::Failure(const std::string& text, double time, std::size_t step, int flag, Solution solution)
    : std::runtime_error(text), time_(time), step_(step), flag_(flag), solution_(std::move(solution)) {}

Solution solve(const Problem& problem) {
  check(problem);
  return Run(problem)();
}

}  // namespace vectrix::ode
