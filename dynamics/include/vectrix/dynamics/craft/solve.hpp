#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/motion.hpp>
#include <vectrix/dynamics/craft/tolerances.hpp>
#include <vectrix/dynamics/ode/inlined.hpp>

namespace vectrix {

/// A run of a craft under loads. `ode` holds its settings: breakpoints at which a load jumps, roots, the
/// longest step, the method (one of Verner's). Its right-hand side is that of the craft. Made by problem().
template <CraftType C, class... Loads> struct CraftProblem {
  ode::Problem ode;
  std::shared_ptr<const detail::CraftCore> core;
  std::tuple<Loads...> loads;
};

/// The run from a state until the time `end`.
template <CraftType C, class... Loads>
  requires(!detail::any_refused<Loads...>)
CraftProblem<C, Loads...> problem(const C& craft, const CraftState<C>& start, const Quantity<si::time>& end,
                                  double relative_tolerance, const CraftTolerances& absolute,
                                  const Loads&... loads) {
  static_cast<void>(sizeof(detail::CheckedLoads<C, Loads...>));
  ode::Problem ode;
  ode.initial_state.assign(start.numbers().begin(), start.numbers().end());
  ode.start = start.time().value();
  ode.end = end.value();
  ode.relative_tolerance = relative_tolerance;
  ode.absolute_tolerances = absolute_tolerances(craft.core()->plain, absolute);
  ode.method = ode::Method::verner_9;
  ode.caller = "Spacecraft \"" + craft.core()->plain.hub + '"';
  ode.component_names = craft.core()->component_names;
  return {std::move(ode), craft.core(), {loads...}};
}

template <CraftType C, class... Loads>
  requires detail::any_refused<Loads...> Refused problem(const C&, const CraftState<C>&,
                                                         const Quantity<si::time>&, double,
                                                         const CraftTolerances&, const Loads&...);

/// The motion of a craft over a time interval: states at any time in it. Immutable, cheap to copy.
template <CraftType C> class CraftTrajectory {
 public:
  CraftTrajectory() = delete;  // solve(problem(craft, start, end, ...))
  CraftTrajectory(detail::Trusted, ode::Solution solution) : solution_(std::move(solution)) {}

  Quantity<si::time> start() const { return Quantity<si::time>::from_value(solution_.start()); }
  Quantity<si::time> end() const { return Quantity<si::time>::from_value(solution_.end()); }
  /// Throws BadInput outside [start, end].
  CraftState<C> at(const Quantity<si::time>& time) const {
    typename CraftState<C>::Numbers y;
    solution_.at(time.value(), y);
    return {detail::trusted, time, y};
  }
  /// Steps, events and statistics.
  const ode::Solution& solution() const& { return solution_; }
  ode::Solution solution() && { return solution_; }

 private:
  ode::Solution solution_;
};

/// Integrates the equations of motion with the right-hand side inlined. Throws as ode::solve(): BadInput if
/// the problem is not well posed, ode::Failure if the run cannot be finished.
template <CraftType C, class... Loads> CraftTrajectory<C> solve(const CraftProblem<C, Loads...>& problem) {
  constexpr std::size_t N = C::state_size;
  auto rates =
      std::apply([&](const auto&... load) { return detail::CraftRates<C, Loads...>(problem.core, load...); },
                 problem.loads);
  return {detail::trusted,
          ode::solve<N>(problem.ode, [rates = std::move(rates)](double segment_start, double t,
                                                                std::span<const double, N> y,
                                                                std::span<double, N> ydot) mutable {
            rates(segment_start, t, y.data(), ydot.data());
          })};
}

}  // namespace vectrix
