#include "check.hpp"

#include <cmath>
#include <limits>

#include <vectrix/frames/errors.hpp>

namespace vectrix::ode {
namespace {

using detail::component_name;
using vectrix::detail::text;

void require(const Problem& problem, bool condition, const std::string& message) {
  if (!condition) throw BadInput(problem.caller + ": " + message);
}

void require_finite(const Problem& problem, const std::string& what, double value) {
  require(problem, std::isfinite(value), what + " must be finite, got " + text(value));
}

/// What has no default is NaN if it is left out; 0, in an option that is a plain number.
void require_given(const Problem& problem, const char* what, double value, bool may_be_zero) {
  require(problem, !std::isnan(value) && (may_be_zero || value != 0.0),
          what + (" is left out, or " + text(value)) + "; it has no default");
}

void require_positive(const Problem& problem, const std::string& what, double value) {
  require(problem, std::isfinite(value) && value > 0.0,
          what + " must be finite and greater than 0, got " + text(value));
}

void require_increasing(const Problem& problem, const std::string& what, const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    require_finite(problem, what + " " + text(i), times[i]);
    require(problem, i == 0 || times[i] > times[i - 1],
            what + "s must increase strictly, but number " + text(i) + " = " + text(times[i]) + " follows " +
                text(times[i > 0 ? i - 1 : 0]));
  }
}

void check_tolerances(const Problem& problem) {
  require_given(problem, "relative_tolerance", problem.relative_tolerance, false);
  require_positive(problem, "relative tolerance", problem.relative_tolerance);
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  require(
      problem, problem.relative_tolerance >= rounding,
      "the relative tolerance " + text(problem.relative_tolerance) + " is below rounding, " + text(rounding));
  require(problem, problem.absolute_tolerances.size() == problem.initial_state.size(),
          "the state has " + text(problem.initial_state.size()) + " components, but there are " +
              text(problem.absolute_tolerances.size()) + " absolute tolerances");
  for (std::size_t i = 0; i < problem.absolute_tolerances.size(); ++i) {
    require_positive(problem, "absolute tolerance of " + component_name(problem, i),
                     problem.absolute_tolerances[i]);
  }
}

void check_times(const Problem& problem) {
  require_given(problem, "start", problem.start, true);
  require_given(problem, "end", problem.end, true);
  require_finite(problem, "start", problem.start);
  require_finite(problem, "end", problem.end);
  require(problem, problem.end > problem.start,
          "end = " + text(problem.end) + " must be later than start = " + text(problem.start));
  require_finite(problem, "end - start", problem.end - problem.start);
  require_increasing(problem, "output time", problem.output_times);
  for (const double t : problem.output_times) {
    require(
        problem, t >= problem.start && t <= problem.end,
        "output time " + text(t) + " is outside [" + text(problem.start) + ", " + text(problem.end) + "]");
  }
  require_increasing(problem, "breakpoint", problem.breakpoints);
}

void check_roots(const Problem& problem) {
  for (std::size_t i = 0; i < problem.roots.size(); ++i) {
    const Root& root = problem.roots[i];
    const std::string what = "root " + text(i) + " (" + root.name + ")";
    require(problem, static_cast<bool>(root.function), what + " has no function");
    require(problem,
            root.direction == Direction::rising || root.direction == Direction::falling ||
                root.direction == Direction::any,
            what + " has an unknown direction");
  }
}

}  // namespace

void check(const Problem& problem) {
  require(problem, !problem.initial_state.empty(), "the initial state is empty");
  require(problem,
          problem.component_names.empty() || problem.component_names.size() == problem.initial_state.size(),
          "the state has " + text(problem.initial_state.size()) + " components, but " +
              text(problem.component_names.size()) + " have names");
  for (std::size_t i = 0; i < problem.initial_state.size(); ++i) {
    require_finite(problem, component_name(problem, i) + " of the initial state", problem.initial_state[i]);
  }
  check_tolerances(problem);
  check_times(problem);
  check_roots(problem);
  require(problem, problem.max_steps > 0, "max_steps must be greater than 0");
  require(problem, problem.maximum_step > 0.0,
          "maximum_step must be greater than 0, got " + text(problem.maximum_step));
  require(problem, problem.method >= Method::cvode_adams && problem.method <= Method::radau_iia_7,
          "unknown method " + text(static_cast<int>(problem.method)));
}

}  // namespace vectrix::ode
