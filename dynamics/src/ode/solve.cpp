#include <vectrix/dynamics/ode/solve.hpp>

#include <functional>
#include <utility>

#include <vectrix/dynamics/ode/inlined.hpp>

#include "check.hpp"
#include "radau.hpp"
#include "run.hpp"
#include "sundials_stepper.hpp"

namespace vectrix::ode {

Failure::Failure(const std::string& text, double time, std::size_t step, int flag, Solution solution)
    : std::runtime_error(text), time_(time), step_(step), flag_(flag), solution_(std::move(solution)) {}

std::string detail::why_not_finite(const Problem& problem, double segment_start, double t,
                                   std::span<const double> y) {
  if (!problem.why_not_finite) return "";
  try {
    const std::string why = problem.why_not_finite(segment_start, t, y);
    return why.empty() ? why : ": " + why;
  } catch (const std::exception&) {  // the rates that are not finite are the failure
    return "";
  }
}

Solution detail::solve_with(const Problem& problem,
                            const std::function<std::unique_ptr<Stepper>()>& make_stepper) {
  check(problem);
  return Run(problem, make_stepper())();
}

Solution solve(const Problem& problem) {
  if (!problem.rhs) throw BadInput(problem.caller + ": the problem has no right-hand side");
  return detail::solve_with(problem, [&]() -> std::unique_ptr<Stepper> {
    switch (problem.method) {
      case Method::cvode_adams:
      case Method::cvode_bdf:
        return make_cvode_stepper(problem);
      case Method::arkode_dormand_prince_5:
      case Method::arkode_fehlberg_8:
        return make_arkode_stepper(problem);
      case Method::radau_iia_7:
        return make_radau_stepper(problem);
      case Method::verner_9:
      case Method::verner_7:
        break;
    }
    switch (problem.initial_state.size()) {
      case 7:  // attitude and rate
        return detail::make_inlined<7>(problem, std::cref(problem.rhs));
      case 13:  // and an orbit
        return detail::make_inlined<13>(problem, std::cref(problem.rhs));
      default:
        return detail::make_inlined<std::dynamic_extent>(problem, std::cref(problem.rhs));
    }
  });
}

}  // namespace vectrix::ode
