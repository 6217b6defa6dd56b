#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <vectrix/dynamics/craft/craft_scenario.hpp>
#include <vectrix/dynamics/load/act.hpp>
#include <vectrix/dynamics/load/finite.hpp>
#include <vectrix/dynamics/load/joint_units.hpp>

namespace vectrix {

/// The held value of the friction on a joint or a rotor: it sticks, or it slips forwards or backwards.
template <class On> struct StickSlip {
  int slips = 0;      ///< 0: it sticks; else the sign of its speed
  double from = 0.0;  ///< its speed times that sign when it broke away: 0, or a rounding below
  bool operator==(const StickSlip&) const = default;
};

namespace detail {

template <class C, class On, class Effort, class Speed, class Damping> constexpr bool is_friction() {
  using Units = AxisUnits<C, On, true>;
  if constexpr (is_damping<Units, Damping>())
    return std::is_same_v<Effort, typename Units::effort> && std::is_same_v<Speed, typename Units::speed>;
  return false;
}

template <class C, class On, class S> S speed_of(const Now<C, S>& now) {
  if constexpr (C::shape::template has_rotor<On>)
    return now.spin(of<On>).value();
  else
    return now.speed(of<On>).value();
}

/// Where the speed is among the numbers of the state.
template <class C, class On> constexpr std::size_t speed_number() {
  if constexpr (C::shape::template has_rotor<On>)
    return C::shape::template spin_at<On>;
  else
    return C::shape::template speed_at<On>;
}

/// Whether the motion of a joint or rotor is given, with its acceleration.
struct Driven {
  bool is_driven;
  double acceleration;
};
template <class C, class On> Driven drive_of(const Now<C>& now) {
  using Shape = typename C::shape;
  const auto& work = now.instant().work();
  if constexpr (Shape::template has_rotor<On>) {
    constexpr std::size_t rotor = Shape::template spin_at<On> - Shape::rotors_begin;
    return {work.held_rotors[rotor] == multibody::Hold::driven, work.given_spins[rotor]};
  } else {
    return {work.held[Shape::template link_of<On>() - 1] == multibody::Hold::driven,
            work.given[Shape::template speed_at<On> - Shape::speeds_begin]};
  }
}
inline int sign(double x) {
  return (x > 0.0) - (x < 0.0);
}

/// The effort that keeps the speed of a locked joint or rotor, besides what the loads apply.
template <class C, class On> double sticking_effort(const Now<C>& now) {
  using Shape = typename C::shape;
  const auto& work = now.instant().work();
  const auto& tree = now.instant().core().tree;
  if constexpr (Shape::template has_rotor<On>) {
    constexpr std::size_t rotor = Shape::template spin_at<On> - Shape::rotors_begin;
    constexpr int body =
        static_cast<int>(Shape::template link_of<typename Shape::template Part<On>::carrier>());
    return tree.numbers().rotors[rotor].inertia *
               multibody::dot(work.axes[rotor], tree.accelerations(body, work).alpha) -
           work.motors[rotor];
  } else {
    return tree.holding_effort(static_cast<int>(Shape::template link_of<On>()), work);
  }
}

}  // namespace detail

/// Friction on a hinge, a slider or a rotor. Made by friction().
template <CraftType C, class On, class Effort, class Speed, class Damping> struct JointFriction {
  Quantity<Effort> coulomb, breakaway;
  Quantity<Speed> stribeck_speed;
  Quantity<Damping> viscous;

  /// At rest exactly M_s.
  template <class S> Quantity<Effort, S> effort(int slips, const S& speed) const {
    using std::expm1;
    const S of_stribeck = speed / stribeck_speed.value();
    const S level =
        breakaway.value() + (breakaway.value() - coulomb.value()) * expm1(-of_stribeck * of_stribeck);
    return Quantity<Effort, S>::from_value(-slips * level - viscous.value() * speed);
  }

  using State = StickSlip<On>;
  using Solved = detail::Solved<C, State>;
  static constexpr double least = std::numeric_limits<double>::min();

  /// By how much the effort that keeps it at rest is above M_s; negative unless it then also begins to slip
  /// that way, which rounding may prevent. If it is driven, the speed that it is given.
  double excess(const Solved& at) const {
    const Now<C> sticking = at.with(State{}).now;
    if (detail::drive_of<C, On>(sticking).is_driven) return std::abs(detail::speed_of<C, On>(at.now)) - least;
    const double above = std::abs(detail::sticking_effort<C, On>(sticking)) - breakaway.value();
    if (above > 0.0 && slips_first(at) != 0) return above;
    return std::min(above, -least);
  }
  /// The direction in which it begins to slip from rest, or is driven; 0: it stays there.
  int slips_first(const Solved& at) const {
    const Now<C> sticking = at.with(State{}).now;
    const double speed = detail::speed_of<C, On>(at.now);
    if (const auto [is_driven, acceleration] = detail::drive_of<C, On>(sticking); is_driven)
      return detail::sign(speed != 0.0 ? speed : acceleration);
    const double effort = detail::sticking_effort<C, On>(sticking);
    if (!(std::abs(effort) > breakaway.value())) return 0;
    const int slips = effort < 0.0 ? 1 : -1;
    return slips * at.with(State{slips}).rates[detail::speed_number<C, On>()] > 0.0 ? slips : 0;
  }

  template <std::size_t> auto parts() const {
    const auto speed = [](const Now<C>& now) { return detail::speed_of<C, On>(now); };
    const auto load = [law = *this]<class S>(const Now<C, S>& now, Forces<C, S>& forces, const State& state) {
      if (state.slips == 0)
        forces.stick(detail::trusted, of<On>);
      else
        detail::act<On>(forces, law.effort(state.slips, detail::speed_of<C, On>(now)));
    };
    const auto at_first = [speed](const Now<C>& now) { return State{detail::sign(speed(now))}; };
    const auto slipping = [speed](const Now<C>& now, const State& state) {
      return state.slips == 0 ? 1.0 : state.slips * speed(now) - state.from + least;
    };
    const auto breaking = [law = *this](const Solved& at, const State& state) {
      return state.slips == 0 ? law.excess(at) : -1.0;
    };
    const auto as_it_is = [](const Now<C>&, const State& state) { return state; };
    const auto rests = [speed](const Now<C>& now, const State& state) {
      return !(state.slips * speed(now) > 0.0);
    };
    const auto begins = [law = *this, speed](const Solved& at) {
      const int slips = law.slips_first(at);
      return State{slips, std::min(slips * speed(at.now), 0.0)};
    };
    const std::string name = frame_name<On>();
    return std::tuple{held(State{}),
                      load,
                      at_start(at_first),
                      when(name + " comes to rest", slipping, ode::Direction::falling, becomes(State{})),
                      when(name + " breaks away", breaking, ode::Direction::rising, as_it_is),
                      detail::StandsStill<State>{detail::speed_number<C, On>(), State{1}},
                      detail::after_impulse(at_first),
                      detail::settling(rests, begins)};
  }
};

/// Friction of Coulomb, Stribeck and viscous on a hinge, a slider or a rotor with the speed u:
///     M = -sign(u) (M_c + (M_s - M_c) exp(-(u/u_s)^2)) - c u
/// At rest it sticks, with a speed of exactly zero, until the effort that this needs is above the breakaway
/// effort M_s, also by a jump of another load; it then slips in the direction of the effort. The speed that
/// is left at the rounded time at which it comes to rest is set to zero, and the momentum loses it. Whether
/// it sticks is the held value StickSlip<On>; the zeros are events of the run. Where the motion is
/// prescribed, friction does not stick: it only loads the drive, with the sign of the speed in the state. A
/// drive at rest may have any effort up to M_s of it: it is zero if that speed is exactly zero, M_s if
/// rounding has left some. A locked joint stays locked whatever its friction. Coulomb's law alone has M_s =
/// M_c and any u_s. Throws BadInput for a number that is not finite, negative, or 0 for M_s or u_s, and if
/// M_s < M_c.
template <CraftType C, class On, class Effort, class Speed, class Damping>
  requires(detail::is_friction<C, On, Effort, Speed, Damping>())
JointFriction<C, On, Effort, Speed, Damping> friction(const C&, Of<On>, const Quantity<Effort>& coulomb,
                                                      const Quantity<Effort>& breakaway,
                                                      const Quantity<Speed>& stribeck_speed,
                                                      const Quantity<Damping>& viscous) {
  const auto load = detail::on_joint<On>("friction");
  detail::not_negative(load, "Coulomb effort", coulomb);
  detail::positive(load, "breakaway effort", breakaway);
  if (breakaway < coulomb)
    throw BadInput(load.text() + ": the breakaway effort is " + detail::all_digits(breakaway) +
                   ", less than the Coulomb effort, " + detail::all_digits(coulomb));
  detail::positive(load, "Stribeck speed", stribeck_speed);
  detail::not_negative(load, "viscous damping", viscous);
  return {coulomb, breakaway, stribeck_speed, viscous};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto friction(  // craft, of<B>, M_c, M_s, u_s, c; hinge, rotor: N m, rad/s, N m s/rad; slider: N, m/s, N s/m
    const Given&...) -> Refused = delete;

}  // namespace vectrix
