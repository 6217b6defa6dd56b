#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/attitude_state.hpp>
#include <vectrix/dynamics/craft/state.hpp>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/scalar/larger.hpp>

namespace vectrix {
namespace detail {

/// A held value from a time on, until the next.
template <class X> struct HeldFrom {
  double time;
  X value;
};
template <class X> using HeldHistory = std::vector<HeldFrom<X>>;

// Throws BadInput: what, a time, is outside the solution.
[[noreturn]] VECTRIX_EXPORT void refuse_time(const std::string& what, double time,
                                             const ode::Solution& solution);
// The same of a trajectory of a hub relative to an inertial frame; both names.
[[noreturn]] VECTRIX_EXPORT void refuse_time_of_craft(NameFunction hub, NameFunction inertial, double time,
                                                      const ode::Solution& solution);

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
  using MotionOfHub = typename detail::HubStart<typename C::shape>::type;

 public:
  CraftTrajectory() = delete;  // propagate(scenario(craft, ...), start, how)
  CraftTrajectory(detail::Trusted, ode::Solution solution, std::tuple<detail::HeldHistory<X>...> history)
      : solution_(std::move(solution)), history_(std::move(history)) {}

  Quantity<si::time> start() const { return Quantity<si::time>::from_value(solution_.start()); }
  Quantity<si::time> end() const { return Quantity<si::time>::from_value(solution_.end()); }
  /// Throws BadInput outside [start, end].
  CraftState<C> at(const Quantity<si::time>& time) const {
    if (node_count() > 0 && !(time >= start() && time <= end())) {
      detail::refuse_time_of_craft(frame_name<typename C::shape::hub>,
                                   frame_name<typename C::shape::inertial>, time.value(), solution_);
    }
    if (attitude() == AttitudeState::dcm) return read(time.value(), solution_.at(time.value()));
    typename CraftState<C>::Numbers y;
    solution_.at(time.value(), y);
    return {detail::trusted, time, y};
  }
  /// The motion of the hub: an edge of a frame graph that is asked at a time, edge(trajectory). Of all bodies
  /// and mounts: frame_graph_of(), asked at a state. Throws as at() does.
  MotionOfHub operator()(const Quantity<si::time>& time) const {
    if constexpr (C::shape::free)
      return at(time).hub_motion();
    else
      return at(time).turning();
  }

  /// The states at those output times that were reached.
  std::vector<CraftState<C>> outputs() const {
    std::vector<CraftState<C>> states;
    for (std::size_t i = 0; i < solution_.output_times().size(); ++i)
      states.push_back(read(solution_.output_times()[i], solution_.output(i)));
    return states;
  }
  /// The states at the ends of the integrator's own steps. Throws BadInput for an index without a node.
  std::size_t node_count() const { return solution_.node_count(); }
  CraftState<C> node(std::size_t index) const {
    const ode::Node node = solution_.node(index);
    return read(node.t, node.y);
  }
  /// How far the integrated attitude of the hub is from a rotation: the largest | |q|/|q_0| - 1 | or entry of
  /// |R^T R - I| over all nodes.
  double orthonormality_drift() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < solution_.node_count(); ++i)
      largest = detail::larger(largest,
                               detail::attitude_drift(attitude(), solution_.node(i).y, solution_.node(0).y));
    return largest;
  }

  /// The held value of this type; at the instant of a change, the new one. Throws BadInput outside
  /// [start, end].
  template <class Y, class = std::enable_if_t<detail::one_of<Y, X...>>>
  Y held(const Quantity<si::time>& time) const {
    if (!(time >= start() && time <= end())) {
      detail::refuse_time("CraftTrajectory::held: time ", time.value(), solution_);
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
    for (const ode::Event& event : solution_.events())
      events.push_back({event.name, read(event.time, event.state), event.direction});
    return events;
  }
  /// True if a zero stopped the run: the last event.
  bool stopped() const { return solution_.stopped(); }
  /// Steps and statistics. Its numbers are those that were integrated: see AttitudeState.
  const ode::Solution& solution() const& { return solution_; }
  ode::Solution solution() && { return solution_; }

 private:
  AttitudeState attitude() const {
    return solution_.dimension() == C::state_size ? AttitudeState::quaternion : AttitudeState::dcm;
  }
  CraftState<C> read(double time, std::span<const double> integrated) const {
    typename CraftState<C>::Numbers y;
    detail::read_state(attitude(), integrated, y);
    return {detail::trusted, Quantity<si::time>::from_value(time), y};
  }

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
