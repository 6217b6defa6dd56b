#pragma once

#include <vectrix/frames/displacement.hpp>

namespace vectrix {

// One mistake gives one error.
template <class... Given>
  requires(std::same_as<Given, Refused> || ...)
Refused shifted(const Given&...);

namespace detail {

template <class... Given> using ShiftOf = decltype(shifted(std::declval<const Given&>()...));
template <class... Given>
concept Shifts = requires {
  typename ShiftOf<Given...>;
};

}  // namespace detail

/// Takes a quantity at the point p to another point q:
///     shift(x_p_c, r_pq_c)          a twist, a wrench, mass properties
///     shift(x_p_c, r_pq_c, F_c)     a torque takes the force, an angular momentum the linear one, an inertia
///                                   the mass
/// The displacement always leads from the old point to the new one. All operands are expressed in one frame.
/// The law is stated beside each type, at shifted().
template <class AtOldPoint, class By, class... Given>
detail::ShiftOf<AtOldPoint, By, Given...> shift(const AtOldPoint& x_p_c, const By& r_pq_c,
                                                const Given&... given) {
  return shifted(x_p_c, r_pq_c, given...);
}
template <class AtOldPoint, class By, class... Given>
  requires(detail::any_framed<AtOldPoint, By> && !detail::Shifts<AtOldPoint, By, Given...>)
auto shift(  // shift(x_p_c, r_pq_c): from the old point p to the new point q, in one frame
    const AtOldPoint&, const By&, const Given&...) -> Refused = delete;

}  // namespace vectrix
