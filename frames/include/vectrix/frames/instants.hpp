#pragma once

/// A type does not know its instant: R_b^i at t and at t + dt have one. Where VECTRIX_CHECK_INSTANTS is
/// defined, by the CMake option of that name and for the whole program, a quantity that a frame graph answers
/// knows it, and so does what is computed of it. Where two instants meet, TwoInstants is thrown. What a door
/// made or a constant edge carries goes with any instant. Otherwise all of this is nothing.
#ifdef VECTRIX_CHECK_INSTANTS

#include <vectrix/frames/checked_instants.hpp>

// What holds a quantity has another layout then: programs of the two kinds do not link.
#define VECTRIX_QUANTITY [[gnu::abi_tag("check_instants")]]
// `result`, computed of operands that must be of one instant.
#define VECTRIX_OF_ONE_INSTANT(action, result, ...) \
  ::vectrix::detail::of_one_instant(                \
      action, [&] { return result; }, __VA_ARGS__)

#else

#define VECTRIX_QUANTITY
#define VECTRIX_OF_ONE_INSTANT(action, result, ...) result

namespace vectrix {
namespace detail {

inline constexpr bool instants_checked = false;

/// Pass-key of the library's own algebra: what it builds from checked operands is not checked again.
struct Trusted {
  explicit Trusted() = default;
};
inline constexpr Trusted trusted{};

/// The base of what holds the numbers of a quantity.
struct Stamped {
  constexpr explicit Stamped(Trusted) {}
};

/// The pass-key for what is built from operands, at their instant.
template <class... Operands>
[[gnu::always_inline]] inline constexpr Trusted trusted_like(const Operands&...) {
  return trusted;
}

}  // namespace detail

/// The same for any instant: what is to be compared with, or added to, its like at another.
template <class X> X without_instant(const X& x) {
  return x;
}

}  // namespace vectrix

#endif
