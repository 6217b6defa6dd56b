#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/forces.hpp>
#include <vectrix/dynamics/craft/state.hpp>
#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/rates/angular_acceleration.hpp>

namespace vectrix {
namespace detail {

template <class... Loads> inline constexpr bool any_refused = (std::is_same_v<Loads, Refused> || ...);

/// A load that has a held value gives its parts: the load, what it holds, and the changes. Its number among
/// the parts of the scenario tells the held types of two such loads apart.
template <class Part>
concept SeveralParts = requires(const Part& part) {
  part.template parts<0>();
};
template <class C, class Load>
inline constexpr bool has_held_value =
    SeveralParts<Load> && !std::invocable<const Load&, const Now<C>&, Forces<C>&>;
template <class Load>
auto in_a_scenario(  // motion_at(scenario, trajectory, time): the load has a held value, which a scenario
                     // changes
    const Load&) -> Refused = delete;

/// Whether it can act; a mistake in a generic one is found here, near the call of the user.
template <class C, class Load>
inline constexpr bool is_load = requires(const Load& load, const Now<C>& now, Forces<C>& forces) {
  load(now, forces);
};
template <class Load>
auto acts(  // a load is a function of const Now<C>& and Forces<C>&
    const Load&) -> Refused = delete;

/// ydot = f(t, y) of a craft with its loads, in the order given. One for each thread.
template <class C, class S, class... Loads> class CraftRatesIn {
 public:
  explicit CraftRatesIn(std::shared_ptr<const CraftCoreIn<S>> core, const Loads&... loads)
      : CraftRatesIn(std::move(core), std::tuple<Loads...>(loads...)) {}
  CraftRatesIn(std::shared_ptr<const CraftCoreIn<S>> core, const std::tuple<Loads...>& loads)
      : core_(std::move(core)), work_(core_->tree.work()), loads_(loads) {}

  void operator()(double t, const S* y, S* ydot) {
    core_->tree.place(y, work_);
    add_loads(t, y);
    core_->tree.solve(y, ydot, work_);
  }
  /// The loads alone, for another engine: the (n, f) of each body are those of its loads, with the opposite
  /// sign. All of them, or one, counted from 1.
  [[gnu::cold, gnu::noinline]] const multibody::Work<S>& loads(double t, const S* y, std::size_t one = 0) {
    place_for_loads(core_->tree, y, work_);
    if constexpr (sizeof...(Loads) > 0) {
      const Now<C, S> now{trusted, *core_, t, y, work_};
      Forces<C, S> forces{trusted, now, work_};
      add_of(one, now, forces, std::index_sequence_for<Loads...>{});
    }
    return work_;
  }
  /// The first load that gives what is not finite, and what; empty if there is none.
  std::string not_finite(double t, const S* y) {
    const auto of_load = [&](std::size_t one) -> const multibody::Work<S>& { return loads(t, y, one); };
    return first_not_finite_load(core_->plain, sizeof...(Loads), std::ref(of_load));
  }
  multibody::Work<S>& work() { return work_; }

 private:
  [[gnu::always_inline]] void add_loads(double t, const S* y) {
    if constexpr (sizeof...(Loads) > 0) {
      const Now<C, S> now{trusted, *core_, t, y, work_};
      Forces<C, S> forces{trusted, now, work_};
      add(now, forces, std::index_sequence_for<Loads...>{});
    }
  }
  template <std::size_t... i>
  [[gnu::always_inline]] void add(const Now<C, S>& now, Forces<C, S>& forces,
                                  std::index_sequence<i...>) const {
    (std::get<i>(loads_)(now, forces), ...);
  }
  template <std::size_t... i>
  void add_of(std::size_t one, const Now<C, S>& now, Forces<C, S>& forces, std::index_sequence<i...>) const {
    ((one == 0 || one == i + 1 ? std::get<i>(loads_)(now, forces) : void()), ...);
  }

  std::shared_ptr<const CraftCoreIn<S>> core_;
  multibody::Work<S> work_;
  std::tuple<Loads...> loads_;
};
template <class C, class... Loads> class CraftRates : public CraftRatesIn<C, double, Loads...> {
 public:
  explicit CraftRates(const C& craft, const Loads&... loads)
      : CraftRatesIn<C, double, Loads...>(craft.core(), loads...) {}
  CraftRates(const C& craft, const std::tuple<Loads...>& loads)
      : CraftRatesIn<C, double, Loads...>(craft.core(), loads) {}
};

}  // namespace detail

/// A state with its accelerations and what its joints transmit. Made by motion().
template <CraftType C, class S = double> class CraftMotion {
  using Shape = typename C::shape;
  using I = typename Shape::inertial;
  template <class F> static constexpr bool turns = Shape::template has_frame<F>;
  template <class F> static constexpr bool hangs = Shape::template is<F, detail::PartRole::body>;

 public:
  CraftMotion() = delete;  // motion(craft, state, loads...)
  CraftMotion(detail::Trusted, std::shared_ptr<const detail::CraftCoreIn<S>> core,
              const CraftState<C, S>& state, const typename CraftState<C, S>::Numbers& rates,
              multibody::Work<S> work)
      : core_(std::move(core)), state_(state), rates_(rates), work_(std::move(work)) {}

  /// Places and velocities. It must not outlive the motion.
  Now<C, S> now() const& {
    const double t = state_.time().value();
    return {detail::trusted, *core_, t, state_.data(), work_};
  }
  Now<C, S> now() && = delete;  // the view refers to the motion: give the motion a name first

  /// As Now has them.
  Quantity<si::energy, S> energy() const { return now().energy(); }
  Vector<I, si::momentum, S> momentum() const { return now().momentum(); }
  Vector<I, si::angular_momentum, S> angular_momentum() const { return now().angular_momentum(); }

  const CraftState<C, S>& state() const& { return state_; }
  CraftState<C, S> state() && { return state_; }
  operator const CraftState<C, S>&() const& { return state_; }
  operator Quantity<si::time>() const { return state_.time(); }
  /// The derivative of the state.
  const typename CraftState<C, S>::Numbers& rates() const& { return rates_; }
  typename CraftState<C, S>::Numbers rates() && { return rates_; }

  /// alpha_ib^c and a_ib|i^c of the body's origin, relative to the inertial frame.
  template <class B, class D>
    requires(Shape::template has_body<B>&& turns<D>)
  AngularAcceleration<I, B, In<D>, S> angular_acceleration(Of<B>, In<D>)
  const { return AngularAcceleration<I, B, In<D>, S>{detail::trusted, in<D>(accelerations<B>().alpha)}; }
  template <class B, class D>
    requires(Shape::template has_body<B>&& turns<D>)
  Acceleration<I, B, ObservedFrom<I>, In<D>, S> acceleration(Of<B>, In<D>)
  const {
    return Acceleration<I, B, ObservedFrom<I>, In<D>, S>{detail::trusted, in<D>(accelerations<B>().a)};
  }
  template <class B, class D>
  auto angular_acceleration(  // of a body of the craft C, in a frame of C; of other frames: a frame graph
      Of<B>, In<D>) const -> Refused = delete;
  template <class B, class D>
  auto acceleration(  // of a body of the craft C, in a frame of C; of other frames: a frame graph
      Of<B>, In<D>) const -> Refused = delete;

  /// What the joint of b transmits to b: a force, and a torque about b's origin, with the effort.
  template <class B, class D>
    requires(hangs<B>&& turns<D>)
  Vector<D, si::force, S> joint_force(Of<B>, In<D>)
  const { return {detail::trusted, in<D>(reaction<B>().force)}; }
  template <class B, class D>
    requires(hangs<B>&& turns<D>)
  Torque<B, In<D>, S> joint_torque(Of<B>, In<D>)
  const { return Torque<B, In<D>, S>{detail::trusted, in<D>(reaction<B>().torque)}; }
  /// What a lock or a drive adds to the efforts that the loads give the joint of b, so that it keeps its
  /// speed or has its given acceleration: of a hinge or slider; both of a gimbal. Zero, but for rounding, of
  /// a joint that nothing holds.
  template <class B>
  requires Shape::template has_axes<B> auto holding_effort(Of<B>) const {
    constexpr JointKind kind = Shape::template Part<B>::joint;
    constexpr std::size_t axes = detail::counts_of(kind).axes;
    std::array<S, axes> efforts;
    for (std::size_t i = 0; i < axes; ++i)
      efforts[i] = core_->tree.holding_effort(link<B> - static_cast<int>(axes - 1 - i), work_);
    return detail::AxisNumbers<typename detail::JointUnits<kind>::effort, kind, S>::read(efforts.data());
  }
  /// Of a rotor what it adds to its motor; zero if nothing holds it.
  template <class W>
  requires Shape::template has_rotor<W> Quantity<si::torque, S> holding_effort(Of<W>) const {
    return Quantity<si::torque, S>::from_value(
        core_->tree.holding_torque(Shape::template spin_at<W> - Shape::rotors_begin, work_));
  }
  template <class B>
  auto holding_effort(  // of a hinge, a slider, a gimbal or a rotor: of what hangs on one, of the craft C
      Of<B>) const -> Refused = delete;
  template <class B, class D>
  auto joint_force(  // of a body of the craft C that hangs on a joint, in a frame of C
      Of<B>, In<D>) const -> Refused = delete;
  template <class B, class D>
  auto joint_torque(  // of a body of the craft C that hangs on a joint, in a frame of C
      Of<B>, In<D>) const -> Refused = delete;

 private:
  template <class D> Eigen::Matrix<S, 3, 1> in(const multibody::Column<S>& v_h) const {
    return detail::eigen(
        detail::CraftInstant<Shape, S>{*core_, state_.data(), work_}.template from_hub<D>(v_h));
  }
  template <class B> static constexpr int link = static_cast<int>(Shape::template link_of<B>());
  template <class B> auto accelerations() const { return core_->tree.accelerations(link<B>, work_); }
  template <class B> auto reaction() const { return core_->tree.reaction(link<B>, work_); }

  std::shared_ptr<const detail::CraftCoreIn<S>> core_;
  CraftState<C, S> state_;
  typename CraftState<C, S>::Numbers rates_;
  multibody::Work<S> work_;
};

/// The accelerations in a state under loads: functions of const Now<C>& and Forces<C>&. Throws BadInput if a
/// result is not finite.
template <CraftType C, class... Loads>
  requires(!detail::any_refused<Loads...>)
CraftMotion<C> motion(const C& craft, const CraftState<C>& state, const Loads&... loads) {
  if constexpr ((detail::has_held_value<C, Loads> || ...)) {
    return (detail::in_a_scenario(loads), ...);
  } else if constexpr (!(detail::is_load<C, Loads> && ...)) {
    constexpr std::size_t bad = detail::first_of<!detail::is_load<C, Loads>...>();
    return detail::acts(std::get<bad>(std::tie(loads...)));
  } else {
    detail::CraftRates<C, Loads...> rates(craft, loads...);
    typename CraftState<C>::Numbers ydot{};
    const double t = state.time().value();
    rates(t, state.data(), ydot.data());
    const auto why = [&] { return rates.not_finite(t, state.data()); };
    detail::require_finite_rates(*craft.core(), "motion", t, ydot, std::ref(why));
    return {detail::trusted, craft.core(), state, ydot, std::move(rates.work())};
  }
}

template <CraftType C, class... Loads>
  requires detail::any_refused<Loads...> Refused motion(const C&, const CraftState<C>&, const Loads&...);

}  // namespace vectrix
