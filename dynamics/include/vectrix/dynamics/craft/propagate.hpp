#pragma once

#include <cstddef>
#include <exception>
#include <limits>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/attitude_state.hpp>
#include <vectrix/dynamics/craft/flight.hpp>
#include <vectrix/dynamics/craft/no_list.hpp>
#include <vectrix/dynamics/craft/tolerances.hpp>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// How a craft is propagated, until `end`: the error of a step is bounded by relative |y| + absolute, for
/// each number by its unit; there is no default. See ode::Method for what each method is for. A load that is
/// a function of time with a short burst needs a `maximum_step` below it, or a held value. The states at the
/// `output_times`, which increase strictly, are CraftTrajectory::outputs().
struct CraftPropagation {
  Quantity<si::time> end;
  double relative_tolerance;
  CraftTolerances absolute_tolerances;
  ode::Method method = ode::Method::verner_9;
  Quantity<si::time> maximum_step = std::numeric_limits<double>::infinity() * si::second;
  std::size_t max_steps = 10'000'000;
  std::vector<Quantity<si::time>> output_times{detail::no_list<Quantity<si::time>>()};
  AttitudeState attitude = AttitudeState::quaternion;
  /// As ode::Problem::dense_output: false leaves CraftTrajectory::at the nodes and outputs.
  bool dense_output = true;
};

namespace detail {

/// Throws BadInput if the torque w x J w of a craft underflows, while its hub turns far enough in the run for
/// it to matter. Without it the rate would stay constant.
struct GyroscopicTorque {
  const PlainSpacecraft& craft;
  double moments, duration;

  void require(const double* w) const {
    using Limits = std::numeric_limits<double>;
    const double size = moments * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    if (size < Limits::min() / Limits::epsilon()) [[unlikely]]
      require_rest(w, size);
  }
  VECTRIX_EXPORT void require_rest(const double* w, double size) const;
};

/// How a problem of a craft is solved: its tolerances and its method.
VECTRIX_EXPORT ode::Problem problem_of(const PlainSpacecraft& craft, const CraftPropagation& how);
/// Gives the problem its start and its end. Throws BadInput if the end is not later.
VECTRIX_EXPORT void set_run(ode::Problem& problem, const char* action, const CraftCore& core, double start,
                            std::span<const double> state, double end,
                            const std::vector<Quantity<si::time>>& output_times);

/// Whether a part checks a run before it starts.
template <class C, class Part>
inline constexpr bool requires_run = requires(const Part& part, const CraftState<C>& start, double end) {
  part.require_run(start, end);
};

template <class Scenario, class State> inline constexpr bool is_run = CraftType<Scenario>;
template <class C, class... Parts, class State>
inline constexpr bool is_run<CraftScenario<C, Parts...>, State> = true;
template <class Scenario, class C> inline constexpr bool is_run<Scenario, CraftState<C>> = true;
template <class GivenC, class... Parts, class C>
inline constexpr bool is_run<CraftScenario<GivenC, Parts...>, CraftState<C>> = true;

/// Runs a scenario until how.end: `solve(problem, flight)` integrates the problem, which comes with its
/// tolerances and method. No step crosses a change.
template <CraftType C, class... Parts, class How, class Solve>
typename TrajectoryOf<C, HeldTypes<Parts...>>::type fly(const char* action,
                                                        const CraftScenario<C, Parts...>& scenario,
                                                        const CraftState<C>& start, const How& how,
                                                        ode::Problem problem, const Solve& solve) {
  set_run(problem, action, *scenario.craft().core(), start.time().value(), start.numbers(), how.end.value(),
          how.output_times);
  problem.max_steps = how.max_steps;
  problem.maximum_step = how.maximum_step.value();
  for_parts(places<requires_run<C, Parts>...>(),
            [&]<std::size_t i>() { std::get<i>(scenario.parts()).require_run(start, problem.end); });
  Flight<C, Parts...> flight(scenario, problem.start, problem.end);
  problem.breakpoints = flight.breakpoints(problem.start, problem.end);
  problem.roots = flight.roots();
  problem.at_segment_start = [&](double t, std::span<double> y, std::span<const ode::Event> ended_by) {
    flight.change(t, y, ended_by);
  };
  problem.why_not_finite = [&](double, double t, std::span<const double> y) {
    return flight.not_finite(t, y.data());
  };
  try {
    ode::Solution solution = solve(problem, flight);
    return {trusted, std::move(solution), flight.take_history()};
  } catch (const ode::Failure& failure) {
    std::throw_with_nested(typename TrajectoryOf<C, HeldTypes<Parts...>>::failure{
        failure, {trusted, failure.solution(), flight.take_history()}});
  }
}

}  // namespace detail

/// The motion of the craft of a scenario from a state on. No step crosses a change, so that the order of the
/// method is kept. Throws BadInput if a number is not what it must be, and CraftFailure, with the trajectory
/// until then, if the run cannot be finished.
template <CraftType C, class... Parts>
typename detail::TrajectoryOf<C, detail::HeldTypes<Parts...>>::type propagate(
    const CraftScenario<C, Parts...>& scenario, const CraftState<C>& start, const CraftPropagation& how) {
  const PlainSpacecraft& craft = scenario.craft().core()->plain;
  const detail::GyroscopicTorque gyroscopic{craft, detail::size_of_inertia(craft),
                                            how.end.value() - start.time().value()};
  const auto solve = [&](ode::Problem& run, detail::Flight<C, Parts...>& flight) {
    run.rhs = [&flight, &gyroscopic](double, double t, std::span<const double> y, std::span<double> ydot) {
      gyroscopic.require(y.data() + 4);
      flight.rates(t, y.data(), ydot.data());
    };
    return detail::solve_in(how.attitude, std::move(run));
  };
  return detail::fly("propagate", scenario, start, how, detail::problem_of(craft, how), solve);
}

template <class State, class How = CraftPropagation>
Refused propagate(const Refused& scenario, const State&, const How&);
template <class Scenario, class State, class How = CraftPropagation>
  requires(detail::is_run<Scenario, State>)
auto propagate(  // scenario(craft, ...), a state of its craft, and how: CraftPropagation
    const Scenario&, const State&, const How&) -> Refused = delete;

/// The accelerations at a time of a trajectory, and what the joints transmit, under the loads of its scenario
/// with the values held then. Throws BadInput outside [start, end].
template <CraftType C, class... Parts, class... X>
  requires std::is_same_v<detail::HeldTypes<Parts...>, std::tuple<X...>> CraftMotion<C> motion_at(
      const CraftScenario<C, Parts...>& scenario, const CraftTrajectory<C, X...>& trajectory,
      const Quantity<si::time>& time) {
    const std::tuple<X...> values{trajectory.template held<X>(time)...};
    const CraftState<C> state = trajectory.at(time);
    return std::apply([&](const auto&... load) { return motion(scenario.craft(), state, load...); },
                      detail::held_loads(scenario.parts(), values));
  }

template <CraftType C, class... Parts, CraftType GivenC, class... X>
  requires(!(std::is_same_v<C, GivenC> && std::is_same_v<detail::HeldTypes<Parts...>, std::tuple<X...>>))
auto motion_at(  // motion_at(scenario, trajectory, time): a trajectory of the scenario, whose craft and held
                 // values it has
    const CraftScenario<C, Parts...>&, const CraftTrajectory<GivenC, X...>&, const Quantity<si::time>&)
    -> Refused = delete;

}  // namespace vectrix
