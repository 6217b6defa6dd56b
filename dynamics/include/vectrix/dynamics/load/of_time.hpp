#pragma once

#include <concepts>
#include <type_traits>
#include <vectrix/dynamics/load/act.hpp>

namespace vectrix {

/// A load that is a smooth function of time, on a body, a joint or a rotor. Made by of_time().
template <CraftType C, class On, class F> struct OfTime {
  F function;
  template <class S> void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    detail::act<On>(forces, function(now.time()));
  }
};

namespace detail {

template <class C, class On, class F> constexpr bool acts_at_time() {
  if constexpr (std::invocable<const F&, const Quantity<si::time>&>)
    return acts_on<C, On, std::remove_cvref_t<std::invoke_result_t<const F&, const Quantity<si::time>&>>>;
  else
    return false;
}

}  // namespace detail

/// What a function of the time gives, a const Quantity<si::time>&: on a body a torque, a force through its
/// origin, or a wrench, in any frame of the craft; the effort of a joint with one axis; the torque of a body
/// on its rotor. It must be smooth: what jumps is a pulse() or a held value; of a short burst no step may be
/// longer, see CraftPropagation. A late time is coarse, by 1.2e-7 s at 8e8 s, and a fast function of it a
/// staircase that takes short steps: count the time from near the start, and let f add the epoch.
template <CraftType C, class On, class F>
  requires(detail::acts_at_time<C, On, F>())
OfTime<C, On, F> of_time(const C&, Of<On>, const F& function) {
  return {function};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto of_time(  // craft, of<B>, f(t): torque, force, wrench in frames of C; an effort on a joint; N m, rotor
    const Given&...) -> Refused = delete;

}  // namespace vectrix
