#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/forces.hpp>
#include <vectrix/dynamics/craft/given_function.hpp>
#include <vectrix/dynamics/craft/joint_motion.hpp>
#include <vectrix/dynamics/craft/prescribing.hpp>
#include <vectrix/dynamics/craft/state.hpp>
#include <vectrix/dynamics/load/joint_units.hpp>

namespace vectrix {
namespace detail {

template <class C, class B, class Given> constexpr bool is_motion() {
  if constexpr (C::shape::template has_axes<B>)
    return std::is_same_v<Given, typename MotionOfJoint<C::shape::template Part<B>::joint>::type>;
  else
    return C::shape::template has_rotor<B> && std::is_same_v<Given, RotorMotion>;
}
template <class C, class B, class Given>
inline constexpr bool is_motion_of_axis = C::shape::template has_joint_of<B, JointKind::gimbal>&&
    std::is_same_v<Given, typename MotionOfJoint<JointKind::hinge>::type>;

/// One axis of a joint, or a rotor, whose motion is given.
struct GivenAxis {
  std::string joint;
  const char *coordinate, *speed, *acceleration;  ///< the symbols of the units; a rotor has no coordinate
  std::function<JointNumbers(double t)> motion;
};
template <JointKind kind>
GivenAxis given_axis(std::string joint, std::function<JointNumbers(double)> motion) {
  using Units = JointUnits<kind>;
  return {std::move(joint), unit_symbol<typename Units::coordinate>, unit_symbol<typename Units::speed>,
          unit_symbol<typename Units::acceleration>, std::move(motion)};
}
/// Throws BadInput if speed and acceleration are not the derivatives that they should be, at some times from
/// `start` to `end`; or if the joint, which has the coordinate q and the speed u, does not start as given.
VECTRIX_EXPORT void require_motion(const GivenAxis& axis, double start, double end, double q, double u);

}  // namespace detail

/// prescribed(craft, of<B>, f): the joint of b moves as f(t) says, a JointMotion of a hinge or slider, a
/// std::array of two of a gimbal; a rotor turns at a speed of time, a RotorMotion:
///     u' = f''(t), whatever acts on it; CraftMotion::holding_effort(of<B>) is what the drive gives for it
/// Springs and other efforts change only that. f must be smooth between the changes of the scenario. The
/// numbers of the joint stay in the state and are integrated. A run throws BadInput with the numbers if it
/// does not start at f and f' to 1e-6 of their largest values, or if f' and f'' are not the derivatives of f
/// and f' to 1e-5, at five times from its start to its end; and it fails if the joint is also locked. A
/// gimbal may be driven about one axis, about_axis<1> or about_axis<2>, and free about the other.
template <CraftType C, class B, class F> struct PrescribedJoint {
  F motion;

  template <class S> void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    const auto given = motion(now.time());
    if constexpr (C::shape::template has_joint_of<B, JointKind::gimbal>)
      forces.drive(of<B>, given[0].acceleration, given[1].acceleration);
    else
      forces.drive(of<B>, given.acceleration);
  }

  /// What a run requires before it starts.
  void require_run(const CraftState<C>& start, double end) const {
    using Shape = typename C::shape;
    const auto name = detail::on_joint<B>("prescribed").text();
    const auto numbers = [this](std::size_t i) {
      return [this, i](double t) { return detail::numbers_of(motion(t * si::second))[i]; };
    };
    const double* y = start.data();
    if constexpr (Shape::template has_rotor<B>) {
      auto axis = detail::given_axis<JointKind::hinge>(name, numbers(0));
      axis.coordinate = nullptr;
      detail::require_motion(axis, start.time().value(), end, 0.0, y[Shape::template spin_at<B>]);
    } else {
      constexpr JointKind kind = Shape::template Part<B>::joint;
      constexpr std::size_t axes = detail::counts_of(kind).axes;
      for (std::size_t i = 0; i < axes; ++i)
        detail::require_motion(
            detail::given_axis<kind>(name + (axes == 1 ? "" : ", axis " + detail::text(i + 1)), numbers(i)),
            start.time().value(), end, y[Shape::template position_at<B> + i],
            y[Shape::template speed_at<B> + i]);
    }
  }
};

/// A gimbal that moves about one of its axes as a function of time says. Made by prescribed().
template <CraftType C, class B, int axis, class F> struct PrescribedAxis {
  F motion;

  template <class S> void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    forces.drive(of<B>, about_axis<axis>, motion(now.time()).acceleration);
  }
  /// What a run requires before it starts.
  void require_run(const CraftState<C>& start, double end) const {
    using Shape = typename C::shape;
    detail::require_motion(detail::given_axis<JointKind::gimbal>(
                               detail::on_joint<B>("prescribed").text() + ", axis " + detail::text(axis),
                               [this](double t) { return detail::numbers_of(motion(t * si::second))[0]; }),
                           start.time().value(), end, start.data()[Shape::template position_at<B> + axis - 1],
                           start.data()[Shape::template speed_at<B> + axis - 1]);
  }
};

namespace detail {

/// Of a joint or rotor, and of one axis of a gimbal. A function with an error has said why.
template <class C, class B, class Load, bool is_motion, class F> struct PrescribedLoad {
  using given = typename GivenMotion<F>::type;
  static constexpr bool failed = has_error<F, const Quantity<si::time>&>();
  static constexpr bool fits = is_motion || failed;
  static auto made(const F& motion) {
    if constexpr (failed) {
      return Refused{};
    } else {
      require_function([] { return on_joint<B>("prescribed").text(); }, motion);
      return Load{motion};
    }
  }
};
template <CraftType C, class B, class F>
struct Prescribed<C, Of<B>, F> : PrescribedLoad<C, B, PrescribedJoint<C, B, std::decay_t<F>>,
                                                is_motion<C, B, typename GivenMotion<F>::type>(), F> {
  static auto make(const C&, Of<B>, const F& motion) { return Prescribed::made(motion); }
};
template <CraftType C, class B, int axis, class F>
struct Prescribed<C, Of<B>, AboutAxis<axis>, F>
    : PrescribedLoad<C, B, PrescribedAxis<C, B, axis, std::decay_t<F>>,
                     is_motion_of_axis<C, B, typename GivenMotion<F>::type>, F> {
  static auto make(const C&, Of<B>, AboutAxis<axis>, const F& motion) { return Prescribed::made(motion); }
};

}  // namespace detail

}  // namespace vectrix
