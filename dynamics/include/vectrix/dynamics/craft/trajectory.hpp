#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/state.hpp>
#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix {
namespace detail {

/// A held value from a time on, until the next.
template <class X> struct HeldFrom {
  double time;
  X value;
};
template <class X> using HeldHistory = std::vector<HeldFrom<X>>;

}  // namespace detail

/// A zero of a function of a scenario, found in its run.
template <CraftType C> struct CraftEvent {
  std::string name;
  CraftState<C> state;
  ode::Direction direction;
};

/// The motion of a craft over a time interval, and the values of the types X that its scenario held.
/// Immutable; threads may share it. Made by propagate().
template <CraftType C, class... X> class CraftTrajectory {
 public:
  CraftTrajectory() = delete;  // propagate(scenario(craft, ...), start, how)
  CraftTrajectory(detail::Trusted, ode::Solution solution, std::tuple<detail::HeldHistory<X>...> history)
      : solution_(std::move(solution)), history_(std::move(history)) {}

  Quantity<si::time> start() const { return Quantity<si::time>::from_value(solution_.start()); }
  Quantity<si::time> end() const { return Quantity<si::time>::from_value(solution_.end()); }
  /// Throws BadInput outside [start, end].
  CraftState<C> at(const Quantity<si::time>& time) const {
    typename CraftState<C>::Numbers y;
    solution_.at(time.value(), y);
    return {detail::trusted, time, y};
  }
  /// The held value of this type; at the instant of a change, the new one. Throws BadInput outside
  /// [start, end].
  template <class Y, class = std::enable_if_t<detail::one_of<Y, X...>>>
  Y held(const Quantity<si::time>& time) const {
    if (!(time >= start() && time <= end())) {
      throw BadInput("CraftTrajectory::held: time " + detail::text(time.value()) + " s is outside [" +
                     detail::text(solution_.start()) + ", " + detail::text(solution_.end()) + "] s");
    }
    const auto& history = std::get<detail::HeldHistory<Y>>(history_);
    const auto later = [](double t, const detail::HeldFrom<Y>& from) { return t < from.time; };
    return std::prev(std::upper_bound(history.begin(), history.end(), time.value(), later))->value;
  }
  template <class Y, std::enable_if_t<!detail::one_of<Y, X...>, int> = 0>
  auto held(const Quantity<si::time>&) const -> Refused = delete;  // a type that the scenario holds

  /// The zeros of the functions of when(), in order of time.
  std::vector<CraftEvent<C>> events() const {
    std::vector<CraftEvent<C>> events;
    for (const ode::Event& event : solution_.events()) {
      typename CraftState<C>::Numbers y;
      std::copy(event.state.begin(), event.state.end(), y.begin());
      events.push_back(
          {event.name, {detail::trusted, Quantity<si::time>::from_value(event.time), y}, event.direction});
    }
    return events;
  }
  /// True if a zero stopped the run: the last event.
  bool stopped() const { return solution_.stopped(); }
  /// Steps and statistics.
  const ode::Solution& solution() const& { return solution_; }
  ode::Solution solution() && { return solution_; }

 private:
  ode::Solution solution_;
  std::tuple<detail::HeldHistory<X>...> history_;
};

/// A run that could not be finished: time, step and flag of the solver, and the trajectory until then. It
/// nests the ode::Failure (std::rethrow_if_nested), which nests the exception of a load, a change or a
/// function of when(), if there was one.
template <CraftType C, class... X> class CraftFailure : public ode::Failure {
 public:
  CraftFailure(const ode::Failure& failure, CraftTrajectory<C, X...> trajectory)
      : ode::Failure(failure), trajectory_(std::move(trajectory)) {}

  const CraftTrajectory<C, X...>& trajectory() const { return trajectory_; }

 private:
  CraftTrajectory<C, X...> trajectory_;
};

}  // namespace vectrix
