#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vectrix/dynamics/craft/craft_scenario.hpp>
#include <vectrix/dynamics/load/act.hpp>
#include <vectrix/dynamics/load/finite.hpp>

namespace vectrix {

/// The held value of the friction on a joint or a rotor: it sticks, or it slips forwards or backwards.
template <class On> struct StickSlip {
  int slips = 0;  ///< 0: it sticks; else the sign of its speed
  bool operator==(const StickSlip&) const = default;
};

namespace detail {

template <class C, class On>
inline constexpr bool turns_with_friction =
    C::shape::template has_joint_of<On, JointKind::hinge> || C::shape::template has_rotor<On>;
template <class C, class On>
inline constexpr bool slides_with_friction = C::shape::template has_joint_of<On, JointKind::slider>;

/// Whether the units are those of the effort and the speed of a hinge or rotor, or of a slider.
template <class C, class On, class Effort, class Speed, class Damping> constexpr bool is_friction() {
  if constexpr (std::is_same_v<unit_product<Damping, Speed>, Effort>)
    return (turns_with_friction<C, On> && std::is_same_v<Effort, si::torque> &&
            std::is_same_v<Speed, si::angular_velocity>) ||
           (slides_with_friction<C, On> && std::is_same_v<Effort, si::force> &&
            std::is_same_v<Speed, si::velocity>);
  return false;
}

template <class C, class On> double speed_of(const Now<C>& now) {
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
    constexpr std::size_t link = Shape::template link_of<On>();
    const auto transmitted = tree.reaction(static_cast<int>(link), work);
    const auto& along = turns_with_friction<C, On> ? transmitted.torque : transmitted.force;
    return multibody::dot(work.links[link - 1].axis, along) -
           work.efforts[Shape::template speed_at<On> - Shape::speeds_begin];
  }
}

}  // namespace detail

/// Friction on a hinge, a slider or a rotor. Made by friction().
template <CraftType C, class On, class Effort, class Speed, class Damping> struct JointFriction {
  Quantity<Effort> coulomb, breakaway;
  Quantity<Speed> stribeck_speed;
  Quantity<Damping> viscous;

  Quantity<Effort> effort(int slips, double speed) const {
    const double of_stribeck = speed / stribeck_speed.value();
    const double level =
        coulomb.value() + (breakaway.value() - coulomb.value()) * std::exp(-of_stribeck * of_stribeck);
    return Quantity<Effort>::from_value(-slips * level - viscous.value() * speed);
  }

  template <std::size_t> auto parts() const {
    using State = StickSlip<On>;
    const auto load = [law = *this](const Now<C>& now, Forces<C>& forces, const State& state) {
      if (state.slips == 0)
        forces.lock(of<On>);
      else
        detail::act<On>(forces, law.effort(state.slips, detail::speed_of<C, On>(now)));
    };
    const auto at_first = [](const Now<C>& now) {
      const double speed = detail::speed_of<C, On>(now);
      return State{(speed > 0.0) - (speed < 0.0)};
    };
    const auto slipping = [](const Now<C>& now, const State& state) {
      return state.slips == 0 ? 1.0 : state.slips * detail::speed_of<C, On>(now);
    };
    const auto excess = [limit = breakaway.value()](const detail::Solved<C>& at, const State& state) {
      return state.slips == 0 ? std::abs(detail::sticking_effort<C, On>(at.now)) - limit : -limit;
    };
    const auto breaking = [limit = breakaway.value()](const detail::Solved<C>& at) {
      const double effort = detail::sticking_effort<C, On>(at.now);
      return State{std::abs(effort) < limit ? 0 : effort < 0.0 ? 1 : -1};
    };
    const auto as_it_is = [](const Now<C>&, const State& state) { return state; };
    const std::string name = frame_name<On>();
    return std::tuple{held(State{}),
                      load,
                      at_start(at_first),
                      when(name + " comes to rest", slipping, ode::Direction::falling, becomes(State{})),
                      when(name + " breaks away", excess, ode::Direction::rising, as_it_is),
                      detail::StandsStill<State>{detail::speed_number<C, On>()},
                      detail::settling(breaking)};
  }
};

/// Friction of Coulomb, Stribeck and viscous on a hinge, a slider or a rotor with the speed u:
///     M = -sign(u) (M_c + (M_s - M_c) exp(-(u/u_s)^2)) - c u
/// At rest it sticks, its speed is zero exactly, until the effort that this needs reaches the breakaway
/// effort M_s, also by a jump of another load. What is left of the speed as it comes to rest, at a rounded
/// time, is set to zero; the momentum loses it. Whether it sticks is the held value StickSlip<On>; the zeros
/// are events of the run. Coulomb's law alone has M_s = M_c and any
/// u_s. Throws BadInput for a number that is not finite, negative, or 0 for M_s or u_s, and if M_s < M_c.
template <CraftType C, class On, class Effort, class Speed, class Damping>
  requires(detail::is_friction<C, On, Effort, Speed, Damping>())
JointFriction<C, On, Effort, Speed, Damping> friction(const C&, Of<On>, const Quantity<Effort>& coulomb,
                                                      const Quantity<Effort>& breakaway,
                                                      const Quantity<Speed>& stribeck_speed,
                                                      const Quantity<Damping>& viscous) {
  detail::not_negative("friction", "Coulomb effort", coulomb);
  detail::positive("friction", "breakaway effort", breakaway);
  if (breakaway < coulomb)
    throw BadInput("friction: the breakaway effort is " + detail::text(breakaway) +
                   ", less than the Coulomb effort, " + detail::text(coulomb));
  detail::positive("friction", "Stribeck speed", stribeck_speed);
  detail::not_negative("friction", "viscous damping", viscous);
  return {coulomb, breakaway, stribeck_speed, viscous};
}
template <class C, class On, class Effort, class Breakaway, class Speed, class Damping>
auto friction(  // on a hinge or rotor: M_c, M_s in N m, u_s in rad/s, c in N m s/rad; on a slider: N, m/s, N
                // s/m
    const C&, Of<On>, const Effort&, const Breakaway&, const Speed&, const Damping&) -> Refused = delete;

}  // namespace vectrix
