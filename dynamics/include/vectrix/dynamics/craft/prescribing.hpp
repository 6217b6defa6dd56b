#pragma once

#include <concepts>
#include <type_traits>
#include <vectrix/dynamics/craft/about_frames.hpp>
#include <vectrix/frames/operators.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {
namespace detail {

/// What a function of the time gives.
template <class F> struct GivenMotion { using type = void; };
template <class F>
  requires std::invocable < const F&, const Quantity<si::time>
& > struct GivenMotion<F> {
  using type = std::remove_cvref_t<std::invoke_result_t<const F&, const Quantity<si::time>&>>;
};

/// What prescribed() makes of what it is given, in types and in names: one function for all, so that a
/// refusal names few. `given` is what the function gives.
template <class... Given> struct Prescribed {
  static constexpr bool fits = false;
  using given = void;
};

}  // namespace detail

/// prescribed(craft, of<B>, f), a load, and prescribed("name", f), which a NamedSpacecraft takes: see
/// PrescribedJoint and NamedHeld.
template <class... Given>
  requires(detail::Prescribed<Given...>::fits)
auto prescribed(const Given&... given) {
  return detail::Prescribed<Given...>::make(given...);
}
template <class... Given, class Result = typename detail::Prescribed<Given...>::given>
  requires(detail::about_frames<Given...> && !detail::Prescribed<Given...>::fits)
auto prescribed(  // craft, of<B>, f: JointMotion{rad, rad/s, rad/s^2}, two of a gimbal; rotor: RotorMotion
    const Given&...) -> Refused = delete;

}  // namespace vectrix
