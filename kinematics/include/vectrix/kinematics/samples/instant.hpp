#pragma once

#include <sstream>
#include <string>
#include <type_traits>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/units.hpp>
#include <vectrix/frames/vector.hpp>

namespace vectrix {
namespace detail {

template <class I> using DurationOf = decltype(std::declval<const I&>() - std::declval<const I&>());

}  // namespace detail

/// The type by which samples are ordered: a time, or an instant such as an Epoch. Instants have an order, and
/// the difference of two is a duration.
template <class I>
concept Instant = requires(const I& a, const I& b) {
  a < b;
  requires std::same_as<typename detail::UnitOf<detail::DurationOf<I>>::type, si::time>;
};

namespace detail {

template <class I> struct InstantScalarOf {
  using type = std::remove_cvref_t<decltype(DurationOf<I>{}.value())>;
};
template <class U, class S> struct InstantScalarOf<Quantity<U, S>> { using type = S; };

}  // namespace detail

/// The scalar of the durations.
template <Instant I> using InstantScalar = typename detail::InstantScalarOf<I>::type;

namespace detail {

template <class U, class S> std::string instant_text(const Quantity<U, S>& t) {
  return text(t.value()) + " s";
}
template <class I> std::string instant_text(const I& instant) {
  std::ostringstream out;
  out << instant;
  return out.str();
}

}  // namespace detail
}  // namespace vectrix
