#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>
#include <vectrix/dynamics/craft/no_list.hpp>
#include <vectrix/dynamics/force/gravity.hpp>
#include <vectrix/dynamics/rigid/euler.hpp>
#include <vectrix/dynamics/rigid/state.hpp>

namespace vectrix {

namespace detail {

/// The return type of a function for an argument, for messages; void if it cannot be called with it.
template <class Function, class Argument> struct ReturnedOf : std::type_identity<void> {};
template <class Function, class Argument>
  requires std::invocable<Function, const Argument&>
struct ReturnedOf<Function, Argument> : std::invoke_result<Function, const Argument&> {
};
template <class Function, class Argument> using Returned = typename ReturnedOf<Function, Argument>::type;

}  // namespace detail

/// A torque constant in body axes that acts for start <= t < stop.
template <Frame B> struct PulseTorque {
  Quantity<si::time> start;
  Quantity<si::time> stop;
  Vector<B, si::torque> torque_b;
};

/// A function that takes a state and returns a torque in the body's frame.
template <InertialFrame I, Frame B>
struct TorqueFunction : std::function<Vector<B, si::torque>(const State<I, B>&)> {
  using Base = std::function<Vector<B, si::torque>(const State<I, B>&)>;
  using Base::Base;
  template <class Function, class Returned = detail::Returned<Function, State<I, B>>,
            std::enable_if_t<!std::is_convertible_v<Function, Base>, int> = 0>
  TorqueFunction(Function) = delete;  // from State<I, B> to Vector<B, si::torque>
};

/// A torque that is any function of the state. The times at which it jumps are listed, so that no step
/// crosses them. The integrator never calls the function at such a time, only one rounding before it and one
/// rounding after it; the function may return either value there.
template <InertialFrame I, Frame B> struct CustomTorque {
  TorqueFunction<I, B> torque_b;
  std::vector<Quantity<si::time>> discontinuities{detail::no_list<Quantity<si::time>>()};
};

/// Everything that a propagation, or another engine, needs to know of one rigid body and its torques. An
/// orbit in the initial state needs mu; the gravity-gradient torque needs the orbit.
template <InertialFrame I, Frame B> struct Scenario {
  Inertia<B> inertia;
  State<I, B> initial;
  std::optional<Quantity<si::gravitational_parameter>> mu = std::nullopt;
  bool gravity_gradient = false;
  std::vector<PulseTorque<B>> pulses{detail::no_list<PulseTorque<B>>()};
  std::vector<CustomTorque<I, B>> torques{detail::no_list<CustomTorque<I, B>>()};

  bool torque_free() const { return !gravity_gradient && pulses.empty() && torques.empty(); }
};

namespace detail {

/// The state for the smooth piece that begins at `switched_at`: if its time is a listed jump, the time is
/// moved by one rounding into the piece.
template <class I, class B>
State<I, B> inside_piece(const CustomTorque<I, B>& custom, State<I, B> state,
                         const Quantity<si::time>& switched_at) {
  const auto& jumps = custom.discontinuities;
  if (std::find(jumps.begin(), jumps.end(), state.time) != jumps.end()) {
    const double forever = std::numeric_limits<double>::infinity();
    state.time = Quantity<si::time>::from_value(
        std::nextafter(state.time.value(), switched_at < state.time ? -forever : forever));
  }
  return state;
}

}  // namespace detail

/// The sum of the scenario's torques in a state. A pulse is on or off as at the time `switched_at`: the time
/// of the state or, inside an integrator, the start of the smooth piece that contains the state.
/// Throws BadInput if the gravity-gradient torque lacks mu or the state's orbit.
template <class I, class B>
Vector<B, si::torque> torque(const Scenario<I, B>& scenario, const State<I, B>& state,
                             const Quantity<si::time>& switched_at) {
  Vector<B, si::torque> sum_b = zero<si::torque>(in<B>);
  for (const PulseTorque<B>& pulse : scenario.pulses) {
    if (pulse.start <= switched_at && switched_at < pulse.stop) sum_b = sum_b + pulse.torque_b;
  }
  if (scenario.gravity_gradient) {
    if (!scenario.mu || !state.orbit) {
      throw BadInput("torque(scenario of " + frame_name<B>() +
                     "): the gravity-gradient torque needs mu and an orbit");
    }
    // r^b = R_i^b r^i
    const Vector<B, si::length> r_b = inverse(state.R_i_from_b()) * state.orbit->position.vector();
    sum_b = sum_b + gravity_gradient_torque(*scenario.mu, scenario.inertia, r_b);
  }
  for (const CustomTorque<I, B>& custom : scenario.torques) {
    sum_b = sum_b + custom.torque_b(detail::inside_piece(custom, state, switched_at));
  }
  return sum_b;
}
template <class I, class B>
Vector<B, si::torque> torque(const Scenario<I, B>& scenario, const State<I, B>& state) {
  return torque(scenario, state, state.time);
}

/// h^i = R_b^i J_b w_ib^b, the angular momentum about the centre of mass.
template <class I, class B>
Vector<I, si::angular_momentum> angular_momentum(const Scenario<I, B>& scenario, const State<I, B>& state) {
  return state.R_i_from_b() * (scenario.inertia * state.w_ib_b);
}

namespace detail {

/// Throws BadInput, with the reason, if a scenario cannot be propagated.
template <class I, class B> void require_complete(const Scenario<I, B>& scenario) {
  const std::string place = "Scenario of " + frame_name<B>() + " relative to " + frame_name<I>() + ": ";
  const double start = scenario.initial.time.value();
  if (!std::isfinite(start)) throw BadInput(place + "the initial time is " + text(start) + " s");
  if (!scenario.inertia.has_inverse()) throw BadInput(place + no_inverse(scenario.inertia));
  if (scenario.initial.orbit && !scenario.mu)
    throw BadInput(place + "the initial state has an orbit, but mu is not given");
  if (scenario.mu && !(scenario.mu->value() > 0.0 && std::isfinite(scenario.mu->value()))) {
    throw BadInput(place + "mu is " + text(scenario.mu->value()) + " m^3/s^2");
  }
  if (scenario.gravity_gradient && !scenario.initial.orbit) {
    throw BadInput(place + "the gravity-gradient torque needs an orbit in the initial state");
  }
  for (const PulseTorque<B>& pulse : scenario.pulses) {
    const double from_time = pulse.start.value();
    const double until = pulse.stop.value();
    if (!(std::isfinite(from_time) && std::isfinite(until) && from_time < until)) {
      throw BadInput(place + "a pulse from " + text(from_time) + " s to " + text(until) + " s does not last");
    }
  }
  for (const CustomTorque<I, B>& custom : scenario.torques) {
    if (!custom.torque_b) throw BadInput(place + "a custom torque has no function");
    for (const auto& time : custom.discontinuities) {
      if (!std::isfinite(time.value())) {
        throw BadInput(place + "a discontinuity of a custom torque is at " + text(time.value()) + " s");
      }
    }
  }
}

}  // namespace detail
}  // namespace vectrix
