#pragma once

#include <vectrix/dynamics/mass/inertia.hpp>

namespace vectrix {
namespace detail {

template <class...> inline constexpr bool all_different = true;
template <class First, class... Rest>
inline constexpr bool all_different<First, Rest...> =
    !(std::is_same_v<First, Rest> || ...) && all_different<Rest...>;

}  // namespace detail

// J_p = J_1p + J_2p + ...
template <class Whole, class P, class C, class S, class... B>
  requires detail::all_different<Whole, B...> Inertia<Whole, P, In<C>, S> joined(
      Of<Whole>, const Inertia<B, P, In<C>, S>&... J_p_c) {
    return Inertia<Whole, P, In<C>, S>{detail::trusted, (J_p_c.matrix() + ...)};
  }
template <class Whole, class... Parts>
  requires(std::same_as<Parts, Refused> || ...)
Refused joined(Of<Whole>, const Parts&...);

namespace detail {

template <class Whole, class... Parts>
using JoinOf = decltype(joined(std::declval<Whole>(), std::declval<const Parts&>()...));
template <class Whole, class... Parts>
concept Joins = requires {
  typename JoinOf<Whole, Parts...>;
};

}  // namespace detail

/// Joins different bodies rigidly into one body, which has its own name:
///     J_p = J_1p + J_2p + ...        join(of<Whole>, J_1p_c, J_2p_c, ...)
/// Takes inertias about one point, expressed in one frame; or the mass properties of each body, from one
/// origin (mass_properties.hpp). Accepts any inertias.
template <class Whole, class... Parts>
detail::JoinOf<Of<Whole>, Parts...> join(Of<Whole> whole, const Parts&... parts) {
  return joined(whole, parts...);
}
template <class Whole, class... Parts>
  requires(!detail::Joins<Of<Whole>, Parts...>)
auto join(  // join(of<Whole>, J_1p_c, J_2p_c): different bodies, about one point, expressed in one frame
    Of<Whole>, const Parts&...) -> Refused = delete;

}  // namespace vectrix
