#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vectrix/dynamics/craft/craft_scenario.hpp>
#include <vectrix/dynamics/load/finite.hpp>
#include <vectrix/dynamics/load/joint_units.hpp>

namespace vectrix {

/// The held value of the stops of a joint: which of them pushes.
template <class B> struct AtStop {
  int side = 0;  ///< 1: the upper, -1: the lower, 0: none
  bool operator==(const AtStop&) const = default;
};

/// Two stops of a hinge or slider. Made by stop_at().
template <CraftType C, class B, class K, class D, class Q> struct JointStops {
  Quantity<Q> lower, upper;
  Quantity<K> stiffness;
  Quantity<D> damping;

  /// How far the joint is beyond the stop of a side.
  template <class S> S beyond(int side, const Now<C, S>& now) const {
    const S q = now.coordinate(of<B>).value();
    return side > 0 ? S(q - upper.value()) : S(lower.value() - q);
  }
  /// Smaller than any p > 0: while a stop does not push, its zero is not reached, also where p is 0.
  static constexpr double least = std::numeric_limits<double>::min();

  /// k p + c p'
  template <class S> S push(int side, const Now<C, S>& now) const {
    return stiffness.value() * beyond(side, now) + damping.value() * side * now.speed(of<B>).value();
  }

  template <std::size_t> auto parts() const {
    using State = AtStop<B>;
    const auto load = [stops = *this]<class S>(const Now<C, S>& now, Forces<C, S>& forces, const State& at) {
      using Effort = Quantity<typename decltype(stops.stiffness * stops.upper)::unit, S>;
      if (at.side != 0) forces.effort(of<B>, Effort::from_value(-at.side * stops.push(at.side, now)));
    };
    const auto at_first = [stops = *this](const Now<C>& now) {
      for (const int side : {1, -1}) {
        const double beyond = stops.beyond(side, now);
        if (beyond > 0.0)
          throw BadInput("stop_at: " + frame_name<B>() + " starts at " +
                         detail::all_digits(now.coordinate(of<B>)) + ", outside [" +
                         detail::all_digits(stops.lower) + ", " + detail::all_digits(stops.upper) + "]");
        if (beyond == 0.0 && side * now.speed(of<B>).value() > 0.0) return State{side};
      }
      return State{};
    };
    // A stop that is left by an impulse does not pull, and one that is met anew pushes.
    const auto pushes = [stops = *this](const Now<C>& now) {
      for (const int side : {1, -1})
        if (stops.beyond(side, now) >= 0.0 && stops.push(side, now) > 0.0) return State{side};
      return State{};
    };
    const auto enters = [stops = *this](int side) {
      return [stops, side](const Now<C>& now, const State& at) {
        if (at.side != 0) return -1.0;
        return std::min(stops.beyond(side, now), stops.push(side, now)) - least;
      };
    };
    const auto leaves = [stops = *this](const Now<C>& now, const State& at) {
      return at.side == 0 ? 1.0 : stops.push(at.side, now) + least;
    };
    const auto stays = [](const Now<C>&, const State&) { return false; };
    // At rest exactly at a stop, to which it is pushed.
    const auto leans = [stops = *this](const detail::Solved<C, State>& at) {
      for (const int side : {1, -1}) {
        if (stops.beyond(side, at.now) != 0.0 || at.now.speed(of<B>).value() != 0.0) continue;
        if (side * at.with(State{}).rates[C::shape::template speed_at<B>] > 0.0) return State{side};
      }
      return State{};
    };
    const std::string name = frame_name<B>();
    return std::tuple{
        held(State{}),
        load,
        at_start(at_first),
        when(name + " meets its upper stop", enters(1), ode::Direction::rising, becomes(State{1})),
        when(name + " meets its lower stop", enters(-1), ode::Direction::rising, becomes(State{-1})),
        when(name + " leaves its stop", leaves, ode::Direction::falling, becomes(State{})),
        detail::after_impulse(pushes),
        detail::settling(stays, leans)};
  }
};

/// Two stops of a hinge or slider, each a spring and damper on one side: p beyond a stop, the effort
///     k p + c p'   where p > 0 and k p + c p' > 0, else none
/// pushes back; it never pulls. No step crosses where it begins and ends: those are events of the run, and
/// AtStop<B> is held. Throws BadInput for a number that is not finite, a stiffness that is not positive, a
/// negative damping, or limits that do not increase; a run that starts outside of them fails and says so.
template <CraftType C, class B, class Q, class K, class D>
  requires(detail::is_stiffness<C, B, K, Q>() && detail::is_damping<detail::AxisUnits<C, B>, D>())
JointStops<C, B, K, D, Q> stop_at(const C&, Of<B>, const Quantity<Q>& lower, const Quantity<Q>& upper,
                                  const Quantity<K>& stiffness, const Quantity<D>& damping) {
  const auto load = detail::on_joint<B>("stop_at");
  detail::finite(load, "lower limit", lower);
  detail::finite(load, "upper limit", upper);
  if (!(lower < upper))
    throw BadInput(load.text() + ": the lower limit is " + detail::all_digits(lower) + ", the upper " +
                   detail::all_digits(upper));
  return {lower, upper, detail::positive(load, "stiffness", stiffness),
          detail::not_negative(load, "damping", damping)};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto stop_at(  // craft, of<B>, lower, upper, k, c; hinge: rad, N m/rad, N m s/rad; slider: m, N/m, N s/m
    const Given&...) -> Refused = delete;

}  // namespace vectrix
