#pragma once

#include <exception>
#include <limits>
#include <utility>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/dynamics/scenario/trajectory.hpp>

namespace vectrix {

/// Bounds on the estimated error of a step: relative * |y| + absolute, for each component. The error at the
/// end of a long run is larger. The absolute parts matter where a component passes through zero.
struct Tolerances {
  double relative = 1e-12;
  double attitude = 1e-12;
  Quantity<si::angular_velocity> rate = 1e-15 * (si::radian / si::second);
  Quantity<si::length> position = 1e-6 * si::metre;
  Quantity<si::velocity> velocity = 1e-9 * (si::metre / si::second);
};

/// A function of the state whose zeros are found and reported as events, and that may stop the propagation.
template <InertialFrame I, Frame B> struct Root {
  std::string name;
  std::function<double(const State<I, B>&)> function;
  ode::Direction direction = ode::Direction::any;
  bool stop = false;
};

/// How a scenario is propagated, from its initial time to `end`. A torque that depends on time and is not
/// piecewise constant needs a `maximum_step` shorter than the time in which it changes. Otherwise a step may
/// skip a short burst, and the error estimate of Fehlberg 7(8) cannot detect a rate that depends on time
/// alone. Roots with two zeros close together need it too. See ode::Method for what each method is for; the
/// same tolerances give another error with another method.
template <InertialFrame I, Frame B> struct Propagation {
  Quantity<si::time> end;
  ode::Method method = ode::Method::verner_9;
  AttitudeState attitude = AttitudeState::quaternion;
  Tolerances tolerances = {};
  std::vector<Quantity<si::time>> output_times{detail::no_list<Quantity<si::time>>()};
  std::vector<Root<I, B>> roots{detail::no_list<Root<I, B>>()};
  std::size_t max_steps = 10'000'000;
  Quantity<si::time> maximum_step = std::numeric_limits<double>::infinity() * si::second;
  bool dense_output =
      true;  ///< as ode::Problem::dense_output: false leaves Trajectory::at the nodes and outputs
};

/// A propagation that could not be finished: time, step and flag of the solver, and the trajectory until
/// then. It nests the ode::Failure (std::rethrow_if_nested), which nests the exception of a torque or a root
/// function, if there was one.
template <InertialFrame I, Frame B> class PropagationFailure : public ode::Failure {
 public:
  PropagationFailure(const ode::Failure& failure, Trajectory<I, B> trajectory)
      : ode::Failure(failure), trajectory_(std::move(trajectory)) {}

  const Trajectory<I, B>& trajectory() const { return trajectory_; }

 private:
  Trajectory<I, B> trajectory_;
};

namespace detail {

inline double positive(const char* name, double tolerance) {
  if (!(tolerance > 0.0 && std::isfinite(tolerance))) {
    throw BadInput(std::string{"propagate: the tolerance "} + name + " is " + text(tolerance) +
                   "; it must be positive");
  }
  return tolerance;
}

template <class I, class B>
std::vector<double> absolute_tolerances(const Tolerances& tolerances, const StateLayout<I, B>& layout,
                                        bool orbit) {
  std::vector<double> absolute(layout.attitude_size(), positive("attitude", tolerances.attitude));
  absolute.insert(absolute.end(), 3, positive("rate", tolerances.rate.value()));
  const double position = positive("position", tolerances.position.value());
  const double velocity = positive("velocity", tolerances.velocity.value());
  if (orbit) {
    absolute.insert(absolute.end(), 3, position);
    absolute.insert(absolute.end(), 3, velocity);
  }
  return absolute;
}

/// Throws BadInput if the torque w x J w underflows, while the body turns far enough in the propagation for
/// it to matter. Without it the rate would stay constant.
template <class B, class I>
void require_gyroscopic_torque(const Inertia<B>& J_b, const AngularVelocity<I, B, In<B>>& w_ib_b,
                               double duration) {
  using Limits = std::numeric_limits<double>;
  const double rate = norm(w_ib_b).value();
  const double size = J_b.matrix().trace() * rate * rate;
  if (size < Limits::min() / Limits::epsilon() && rate * duration > Limits::epsilon()) [[unlikely]] {
    throw BadInput("propagate: at the rate " + text(rate) + " rad/s the torque w x J w of " +
                   frame_name<B>() + " underflows, J w^2 = " + text(size) + " N m");
  }
}

template <class I, class B> std::vector<double> breakpoints(const Scenario<I, B>& scenario) {
  std::vector<double> times;
  for (const PulseTorque<B>& pulse : scenario.pulses) {
    times.push_back(pulse.start.value());
    times.push_back(pulse.stop.value());
  }
  for (const CustomTorque<I, B>& custom : scenario.torques) {
    for (const auto& time : custom.discontinuities) times.push_back(time.value());
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace detail

/// Integrates q_b^i (or R_b^i), w_ib^b and the orbit:
///     d/dt q_b^i = 1/2 q_b^i (0, w_ib^b)   or   d/dt R_b^i = R_b^i [w_ib^b]x
///     J_b d/dt w_ib^b = tau^b - w_ib^b x (J_b w_ib^b),   d^2/dt^2 r^i = - mu r^i / |r|^3
/// Steps end where a pulse begins or ends. Throws BadInput for an invalid scenario, tolerance or time, and
/// PropagationFailure, which keeps the trajectory until then, if the solver cannot continue.
template <class I, class B>
Trajectory<I, B> propagate(const Scenario<I, B>& scenario, const Propagation<I, B>& how) {
  detail::require_complete(scenario);
  const bool orbit = scenario.initial.orbit.has_value();
  const detail::StateLayout<I, B> layout(how.attitude, orbit);

  ode::Problem problem;
  problem.initial_state = layout.pack(scenario.initial);
  problem.start = scenario.initial.time.value();
  problem.end = how.end.value();
  for (const auto& time : how.output_times) problem.output_times.push_back(time.value());
  problem.breakpoints = detail::breakpoints(scenario);
  problem.relative_tolerance = detail::positive("relative", how.tolerances.relative);
  problem.absolute_tolerances = detail::absolute_tolerances(how.tolerances, layout, orbit);
  problem.method = how.method;
  problem.max_steps = how.max_steps;
  problem.maximum_step = how.maximum_step.value();
  problem.dense_output = how.dense_output;
  problem.caller = "propagate";
  problem.component_names = layout.names();
  problem.rhs = [&, duration = problem.end - problem.start](
                    double segment_start, double t, std::span<const double> y, std::span<double> ydot) {
    detail::require_gyroscopic_torque(scenario.inertia, layout.rate(y), duration);
    layout.derivative(scenario, segment_start, t, y, ydot);
  };
  for (const Root<I, B>& root : how.roots) {
    if (!root.function) throw BadInput("propagate: the root \"" + root.name + "\" has no function");
    problem.roots.push_back(
        {root.name, [&](double t, std::span<const double> y) { return root.function(layout.unpack(t, y)); },
         root.direction, root.stop});
  }
  try {
    return {detail::trusted, ode::solve(problem), layout};
  } catch (const ode::Failure& failure) {
    std::throw_with_nested(PropagationFailure<I, B>{failure, {detail::trusted, failure.solution(), layout}});
  }
}

template <class I, class B, class GivenI, class GivenB>
  requires(!std::is_same_v<Propagation<I, B>, Propagation<GivenI, GivenB>>)
auto propagate(  // the scenario and its propagation are of the same frames
    const Scenario<I, B>&, const Propagation<GivenI, GivenB>&) -> Refused = delete;

}  // namespace vectrix
