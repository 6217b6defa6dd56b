#include <vectrix/dynamics/craft/propagate.hpp>

#include <cmath>

namespace vectrix::detail {

void GyroscopicTorque::require_rest(const double* w, double size) const {
  const double rate = std::hypot(w[0], w[1], w[2]);
  if (moments > 0.0 && rate * duration > std::numeric_limits<double>::epsilon())
    throw BadInput("propagate: at the rate " + text(rate) + " rad/s the torque w x J w of " + craft.hub +
                   " underflows, J w^2 = " + text(size) + " N m");
}

ode::Problem problem_of(const PlainSpacecraft& craft, const CraftPropagation& how) {
  ode::Problem problem;
  problem.relative_tolerance = how.relative_tolerance;
  problem.absolute_tolerances = absolute_tolerances(craft, how.absolute_tolerances);
  problem.method = how.method;
  problem.dense_output = how.dense_output;
  return problem;
}

void set_run(ode::Problem& problem, const char* action, const CraftCore& core, double start,
             std::span<const double> state, double end, const std::vector<Quantity<si::time>>& output_times) {
  problem.initial_state.assign(state.begin(), state.end());
  problem.start = start;
  problem.end = end;
  for (const Quantity<si::time>& time : output_times) problem.output_times.push_back(time.value());
  problem.caller = action + (" " + core.plain.hub);
  problem.component_names = core.component_names;
  if (!(end > start && std::isfinite(end))) {
    throw BadInput(problem.caller + ": the end is " + text(end) + " s, the start " + text(start) + " s" +
                   (end == 0.0 ? "; .end is left out, or 0, and has no default" : ""));
  }
}

void refuse_time(const std::string& what, double time, const ode::Solution& solution) {
  throw BadInput(what + text(time) + " s is outside [" + text(solution.start()) + ", " +
                 text(solution.end()) + "] s");
}
void refuse_time_of_craft(NameFunction hub, NameFunction inertial, double time,
                          const ode::Solution& solution) {
  refuse_time("CraftTrajectory of " + hub() + " relative to " + inertial() + ": the time ", time, solution);
}

}  // namespace vectrix::detail
