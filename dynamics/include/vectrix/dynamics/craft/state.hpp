#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <vectrix/dynamics/craft/craft_numbers.hpp>
#include <vectrix/dynamics/craft/start.hpp>

namespace vectrix {

/// The state of a spacecraft at one instant: the numbers that are integrated, in the order
///     [ q_h^i 4 | w_ih^h 3 | r_ih^i 3 | v_ih|i^i 3 | joints' positions | joints' speeds | rotors | eta |
///     eta' ]
/// q scalar first, of any norm; rad/s, m, m/s; r and v of the hub's origin, without both if the hub is only
/// turning; the joints in the order of the bodies, each as JointKind says; the speeds of the rotors relative
/// to their bodies, rad/s; the modes, kg^1/2 m and kg^1/2 m/s. An edge of a frame graph that is a function of
/// time takes a state, too. Made by state().
template <CraftType C, class S = double>
class CraftState : public detail::CraftNumbers<CraftState<C, S>, C, S> {
  using Shape = typename C::shape;
  using I = typename Shape::inertial;
  using H = typename Shape::hub;

 public:
  using Numbers = std::array<S, C::state_size>;

  CraftState() = delete;  // state(craft, t, X_i_from_hub, starts...)
  CraftState(detail::Trusted, const Quantity<si::time>& time, const Numbers& numbers)
      : time_(time), numbers_(numbers) {}

  Quantity<si::time> time() const { return time_; }
  operator Quantity<si::time>() const { return time_; }
  const Numbers& numbers() const& { return numbers_; }
  Numbers numbers() && { return numbers_; }
  const S* data() const { return numbers_.data(); }

  /// R_h^i, the nearest rotation to the integrated numbers, and w_ih^h.
  MovingDcm<I, H, S> turning() const {
    return {Dcm<I, H, S>{detail::trusted, detail::eigen(multibody::matrix_of_quaternion(data()))},
            AngularVelocity<I, H, In<H>, S>{detail::trusted, column(4)}};
  }
  /// With r_ih^i and v_ih|i^i.
  template <class Place = Shape>
    requires Place::free MovingTransform<I, H, S> hub_motion()
  const {
    return {turning(), Displacement<I, H, In<I>, S>{detail::trusted, column(7)},
            Velocity<I, H, ObservedFrom<I>, In<I>, S>{detail::trusted, column(10)}};
  }
  template <class Place = Shape>
  auto hub_motion() const -> Refused = delete;  // the hub is turning_in<I>: where it is is not a state

 private:
  Eigen::Matrix<S, 3, 1> column(std::size_t at) const {
    return {numbers_[at], numbers_[at + 1], numbers_[at + 2]};
  }

  Quantity<si::time> time_;
  Numbers numbers_;
};

namespace detail {

template <class I, class H> double* put_hub(const MovingDcm<I, H>& X, double* y) {
  return put_numbers(put_numbers(y, X.rotation.matrix()), X.angular_velocity.coordinates());
}
template <class I, class H> double* put_hub(const MovingTransform<I, H>& X, double* y) {
  return put_numbers(put_numbers(put_hub(X.turning, y), X.translation.coordinates()),
                     X.velocity.coordinates());
}
template <class Shape, class B, JointKind kind, class P>
void put_start(const CraftCore& core, const JointStart<B, kind, P>& start, double* y) {
  const auto put = [](const auto& numbers, double* to) { std::copy(numbers.begin(), numbers.end(), to); };
  double* const positions = y + Shape::template position_at<B>;
  if constexpr (std::is_void_v<P>)
    put(start.positions, positions);
  else
    put(from_mount(core.plain.bodies[Shape::template body_at<B>],
                   {start.positions.begin(), start.positions.end()}),
        positions);
  put(start.speeds, y + Shape::template speed_at<B>);
}
template <class Shape, class W> void put_start(const CraftCore&, const SpinStart<W>& start, double* y) {
  y[Shape::template spin_at<W>] = start.speed;
}
template <class Shape, class A, std::size_t count>
void put_start(const CraftCore&, const DeflectionStart<A, count>& start, double* y) {
  y += Shape::template modes_at<A>;
  std::copy(start.coordinates.begin(), start.coordinates.end(), y);
  std::copy(start.rates.begin(), start.rates.end(), y + Shape::total.modes);
}

template <class C, class Motion, class... Starts>
using StateFault = typename FaultOfState<typename C::shape, Motion, typename FlatList<Starts...>::type>::type;

template <class C, class Motion, class... Starts> constexpr auto fault_of_state() {
  if constexpr (CraftType<C>)
    return std::type_identity<StateFault<C, Motion, Starts...>>{};
  else
    return std::type_identity<IsNoCraft<C>>{};
}

/// Refused starts have said why.
template <class C, class Motion, class... Starts> struct MakesState {
  using Fault = StateFault<C, Motion, Starts...>;
  static constexpr bool value = std::is_same_v<Fault, Nothing> || std::is_same_v<Fault, Refused>;
  using type = std::conditional_t<std::is_same_v<Fault, Refused>, Refused, CraftState<C>>;
};

template <CraftType C>
CraftState<C> checked_state(const C& craft, const char* action, const Quantity<si::time>& t,
                            const std::array<double, C::state_size>& y) {
  require_finite_time(*craft.core(), action, t.value());
  require_state(*craft.core(), action, y);
  return {trusted, t, y};
}

}  // namespace detail

/// Claims that the numbers are a state. Throws BadInput if one is not finite, or a quaternion is zero; any
/// other norm is accepted; or if all mass is on a line.
template <CraftType C>
CraftState<C> state_from_numbers(const C& craft, const Quantity<si::time>& t,
                                 const std::array<double, C::state_size>& y) {
  return detail::checked_state(craft, "state_from_numbers", t, y);
}

/// The state at the time t: the motion of the hub in the inertial frame, and the starts of all joints, rotors
/// and modes; none is zero by default. A motion relative to any other frame is a product away:
///     state(craft, t, X_i_from_lvlh * X_lvlh_from_hub, starts(of<Panel>, angle, rate), spins(of<Wheel>, w))
/// The hub of turning_in<I> needs a MovingDcm only. Throws BadInput for a number that is not finite, and for
/// a craft all whose mass is on a line.
template <CraftType C, class Motion, class... Starts>
  requires(detail::MakesState<C, Motion, Starts...>::value)
typename detail::MakesState<C, Motion, Starts...>::type state(const C& craft, const Quantity<si::time>& t,
                                                              const Motion& X_i_from_hub,
                                                              const Starts&... starts) {
  if constexpr (std::is_same_v<detail::StateFault<C, Motion, Starts...>, Refused>) {
    return Refused{};
  } else {
    typename CraftState<C>::Numbers y{};
    detail::put_hub(X_i_from_hub, y.data());
    (detail::for_each_part(
         starts,
         [&](const auto& start) { detail::put_start<typename C::shape>(*craft.core(), start, y.data()); }),
     ...);
    return detail::checked_state(craft, "state", t, y);
  }
}
template <class C, class Time, class Motion, class... Starts,
          class Fault = typename decltype(detail::fault_of_state<C, Motion, Starts...>())::type>
  requires(!std::is_same_v<Fault, Nothing>)
auto state(  // state(craft, t, X_i_from_hub, starts...): each part that moves has one start: see Fault
    const C&, const Time&, const Motion&, const Starts&...) -> Refused = delete;

}  // namespace vectrix
