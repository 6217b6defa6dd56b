#pragma once

#include <cstddef>
#include <tuple>
#include <vectrix/dynamics/craft/changes.hpp>
#include <vectrix/dynamics/load/act.hpp>
#include <vectrix/dynamics/load/finite.hpp>

namespace vectrix {
namespace detail {

/// Whether the pulse that has this number in its scenario acts.
template <std::size_t number> struct PulseActs { bool value; };

VECTRIX_EXPORT void require_pulse(const Quantity<si::time>& start, const Quantity<si::time>& end);

}  // namespace detail

/// A load that is constant from one time to another, and zero before and after. Made by pulse().
template <CraftType C, class On, class Given> struct Pulse {
  Given given;
  Quantity<si::time> start, end;

  template <std::size_t number> auto parts() const {
    using Acts = detail::PulseActs<number>;
    const auto load = [given = given]<class S>(const Now<C, S>&, Forces<C, S>& forces, const Acts& acts) {
      if (acts.value) detail::act<On>(forces, given);
    };
    const auto acts_already = [from = start, until = end](const Now<C>& now) {
      return Acts{now.time() >= from && now.time() < until};
    };
    return std::tuple{held(Acts{false}), load, at_start(acts_already), at_times({start}, becomes(Acts{true})),
                      at_times({end}, becomes(Acts{false}))};
  }
};

/// From `start` to `end`: on a body a torque, a force through its origin, or a wrench, constant in any frame
/// of the craft; a constant effort of a joint with one axis, or torque of a body on its rotor. It is a held
/// value, so that no step crosses its jumps and the order of the method is kept. A run may start in a pulse.
/// Throws BadInput for a number that is not finite, and if the end is not after the start.
template <CraftType C, class On, class Given>
  requires detail::acts_on<C, On, Given> Pulse<C, On, Given> pulse(const C&, Of<On>, const Given& given,
                                                                   const Quantity<si::time>& start,
                                                                   const Quantity<si::time>& end) {
    detail::require_pulse(start, end);
    return {detail::finite("pulse", "load", given), start, end};
  }
template <class... Given>
  requires(detail::about_frames<Given...>)
auto pulse(  // craft, of<B>, x, t_1, t_2: torque, force, wrench in frames of C; an effort on a joint; N m
    const Given&...) -> Refused = delete;

}  // namespace vectrix
