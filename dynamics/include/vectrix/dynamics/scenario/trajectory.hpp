#pragma once

#include <algorithm>
#include <string>
#include <vector>
#include <vectrix/dynamics/ode/solution.hpp>
#include <vectrix/dynamics/scenario/state_layout.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>

namespace vectrix {

/// A zero of a root function, found in the propagation: its name, state and direction.
template <InertialFrame I, Frame B> struct Event {
  std::string name;
  State<I, B> state;
  ode::Direction direction;
};

/// The motion of one body over a time interval. It is immutable, cheap to copy, and gives the state at any
/// time in the interval (dense output of the order of the steps, see ode::Solution::at).
template <InertialFrame I, Frame B> class Trajectory {
 public:
  Trajectory() = delete;  // propagate(scenario, propagation)
  Trajectory(detail::Trusted, ode::Solution solution, const detail::StateLayout<I, B>& layout)
      : solution_(std::move(solution)), layout_(layout) {}

  Quantity<si::time> start() const { return Quantity<si::time>::from_value(solution_.start()); }
  Quantity<si::time> end() const { return Quantity<si::time>::from_value(solution_.end()); }
  /// True if a root with `stop` ended the propagation. That event is the last of events().
  bool stopped() const { return solution_.stopped(); }

  /// The state at any time in [start, end]. Throws BadInput outside this interval.
  State<I, B> at(const Quantity<si::time>& time) const {
    if (node_count() > 0 && !(time >= start() && time <= end())) {
      throw BadInput("Trajectory of " + frame_name<B>() + " relative to " + frame_name<I>() + ": the time " +
                     detail::text(time.value()) + " s is outside [" + detail::text(start().value()) + ", " +
                     detail::text(end().value()) + "] s");
    }
    return layout_.unpack(time.value(), solution_.at(time.value()));
  }

  /// R_b^i and w_ib^b: an edge of a frame graph, edge(trajectory). Throws as at() does.
  MovingDcm<I, B> operator()(const Quantity<si::time>& time) const {
    const State<I, B> now = at(time);
    return {now.R_i_from_b(), now.w_ib_b};
  }

  /// The states at those requested output times that were reached.
  std::vector<State<I, B>> outputs() const {
    std::vector<State<I, B>> states;
    for (std::size_t i = 0; i < solution_.output_times().size(); ++i) {
      states.push_back(layout_.unpack(solution_.output_times()[i], solution_.output(i)));
    }
    return states;
  }

  std::vector<Event<I, B>> events() const {
    std::vector<Event<I, B>> events;
    for (const ode::Event& event : solution_.events()) {
      events.push_back({event.name, layout_.unpack(event.time, event.state), event.direction});
    }
    return events;
  }

  /// The states at the ends of the integrator's own steps.
  std::size_t node_count() const { return solution_.node_count(); }
  State<I, B> node(std::size_t index) const {
    const ode::Node node = solution_.node(index);
    return layout_.unpack(node.t, node.y);
  }

  /// How far the integrated attitude, before projection, is from a rotation: the largest | |q| - 1 | or entry
  /// of |R^T R - I| over all steps.
  double orthonormality_drift() const {
    double largest = 0.0;
    for (std::size_t i = 0; i < solution_.node_count(); ++i) {
      largest = detail::larger(largest, layout_.drift(solution_.node(i).y));
    }
    return largest;
  }

  ode::Statistics statistics() const { return solution_.statistics(); }

 private:
  ode::Solution solution_;
  detail::StateLayout<I, B> layout_;
};

}  // namespace vectrix
