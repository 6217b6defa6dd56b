#pragma once

#include <iosfwd>
#include <type_traits>
#include <utility>

namespace vectrix {

/// The result type of a refused call. It converts to any type, so that one mistake gives one error.
struct Refused {
  Refused() = default;
  template <class... Given> explicit Refused(const Given&...) {}
  template <class T> operator T() const;
};
template <class Right> Refused product(const Refused&, const Right&);
template <class Left> Refused product(const Left&, const Refused&);
template <class Right> Refused quotient(const Refused&, const Right&);
template <class Left> Refused quotient(const Left&, const Refused&);
template <class Right> Refused sum(const Refused&, const Right&);
template <class Left> Refused sum(const Left&, const Refused&);
template <class Right> Refused difference(const Refused&, const Right&);
template <class Left> Refused difference(const Left&, const Refused&);
template <class Right> Refused dot_product(const Refused&, const Right&);
template <class Left> Refused dot_product(const Left&, const Refused&);
template <class Right> Refused cross_product(const Refused&, const Right&);
template <class Left> Refused cross_product(const Left&, const Refused&);
std::ostream& print_framed(std::ostream&, const Refused&);

/// Why a sum or a difference is refused. The compiler prints the name.
namespace reason {
struct expressed_in_two_frames;
struct in_two_units;
struct no_frame_cancels;        // w_ab_c + w_de_c
struct one_pair_twice;          // w_ab_c + w_ab_c; for two estimates, error_between(w, v)
struct transport_term_is_lost;  // alpha_ib_c - alpha_il_c; use chain()
struct seen_by_two_observers;   // v_ab|o_c + v_bd|p_c; transport() one
struct no_law_for_this_pair;
}  // namespace reason

namespace detail {

/// Types whose operators depend on frames. Each is specialised beside its class.
template <class T> inline constexpr bool is_framed = false;

template <> inline constexpr bool is_framed<Refused> = true;

template <class Left, class Right>
concept FramedPair = is_framed<std::remove_cvref_t<Left>> || is_framed<std::remove_cvref_t<Right>>;

template <class Left, class Right>
using ProductOf = decltype(product(std::declval<Left>(), std::declval<Right>()));
template <class Left, class Right>
using QuotientOf = decltype(quotient(std::declval<const Left&>(), std::declval<const Right&>()));
template <class Left, class Right>
using SumOf = decltype(sum(std::declval<const Left&>(), std::declval<const Right&>()));
template <class Left, class Right>
using DifferenceOf = decltype(difference(std::declval<const Left&>(), std::declval<const Right&>()));
template <class Left, class Right>
using DotOf = decltype(dot_product(std::declval<const Left&>(), std::declval<const Right&>()));
template <class Left, class Right>
using CrossOf = decltype(cross_product(std::declval<const Left&>(), std::declval<const Right&>()));

/// The type of the value of an expression; it differs from T for lazy expressions.
template <class T> struct EvaluatedType : std::type_identity<T> {};
template <class T> using Evaluated = typename EvaluatedType<T>::type;

/// A reference to the left operand, if the result has its type; the operation can then be done in place.
template <class Result, class Left>
using InPlace = std::enable_if_t<std::is_same_v<Evaluated<Result>, Left>, Left&>;

template <template <class, class> class ResultOf, class Left, class Right>
concept Lawful = requires {
  typename ResultOf<Left, Right>;
};
template <template <class, class> class ResultOf, class Left, class Right>
concept LawfulInPlace = requires {
  typename InPlace<ResultOf<Left, Right>, Left>;
};
template <class... Operands> inline constexpr bool any_framed = (is_framed<Operands> || ...);

/// The frame of the axes of a quantity, or void.
template <class X> struct AxesOf : std::type_identity<void> {};
template <class X>
  requires requires {
    typename X::frame;
  }
struct AxesOf<X> : std::type_identity<typename X::frame> {};
template <class X>
  requires requires {
    typename X::expressed;
  }
struct AxesOf<X> : std::type_identity<typename X::expressed> {};
template <class Left, class Right, class LeftAxes = typename AxesOf<Left>::type,
          class RightAxes = typename AxesOf<Right>::type>
inline constexpr bool in_two_frames =
    !std::is_void_v<LeftAxes> && !std::is_void_v<RightAxes> && !std::is_same_v<LeftAxes, RightAxes>;

/// Types with more to say specialise it.
template <class Left, class Right>
struct ReasonOf : std::conditional<in_two_frames<Left, Right>, reason::expressed_in_two_frames,
                                   reason::no_law_for_this_pair> {};
template <class Left, class Right> using ReasonFor = typename ReasonOf<Left, Right>::type;

}  // namespace detail

// There is one operator for all types of the library, so that the compiler lists two candidates for a refused
// expression, not thirty. Each type defines its laws by product(), quotient(), sum(), difference(),
// dot_product() and cross_product(). The result type decides whether an expression is lawful: clang then
// prints one note, but two for a constraint. One operand must be a type of the library, so that a product()
// of the user's defines no operator.

// Forwarded: only temporary chains apply lazily.
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
[[gnu::always_inline]] inline detail::ProductOf<Left, Right> operator*(Left&& left, Right&& right) {
  return product(std::forward<Left>(left), std::forward<Right>(right));
}
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right> && !detail::Lawful<detail::ProductOf, Left, Right>)
auto operator*(  // the inner frames cancel, the kinds go together: R_c_from_b * R_b_from_a, k * w.vector()
    const Left&, const Right&) -> Refused = delete;

template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::QuotientOf<Left, Right>
operator/(const Left& left, const Right& right) {
  return quotient(left, right);
}
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right> && !detail::Lawful<detail::QuotientOf, Left, Right>)
auto operator/(const Left&, const Right&) -> Refused = delete;  // a vector over a number or a quantity

template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::SumOf<Left, Right>
operator+(const Left& left, const Right& right) {
  return sum(left, right);
}
template <class Left, class Right, class Reason = detail::ReasonFor<Left, Right>>
  requires(detail::FramedPair<Left, Right> && !detail::Lawful<detail::SumOf, Left, Right>)
auto operator+(  // one frame and one unit, and the inner frames cancel: r_a + s_a, w_ab_c + w_bd_c
    const Left&, const Right&) -> Refused = delete;

// The unary minus is a member of each type, or deleted there, so it is no candidate for a difference of other
// types.
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::DifferenceOf<Left, Right>
operator-(const Left& left, const Right& right) {
  return difference(left, right);
}
template <class Left, class Right, class Reason = detail::ReasonFor<Left, Right>>
  requires(detail::FramedPair<Left, Right> && !detail::Lawful<detail::DifferenceOf, Left, Right>)
auto operator-(  // one frame and one unit, and the common frame goes: r_a - s_a, w_ib_c - w_il_c is w_lb_c
    const Left&, const Right&) -> Refused = delete;

// Only where the result has the type of the left operand: r_a += s_a, r_a *= 2.0. The sum of two rates has
// another type: w_ab_c + w_bd_c is w_ad_c.
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::InPlace<detail::SumOf<Left, Right>, Left>
operator+=(Left& left, const Right& right) {
  return left = sum(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed<Left> && !detail::LawfulInPlace<detail::SumOf, Left, Right>)
auto operator+=(  // a sum of the same type: r_a += s_a; a chain is another, w_ad_c = w_ab_c + w_bd_c
    Left&, const Right&) -> Refused = delete;

template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::InPlace<detail::DifferenceOf<Left, Right>, Left>
operator-=(Left& left, const Right& right) {
  return left = difference(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed<Left> && !detail::LawfulInPlace<detail::DifferenceOf, Left, Right>)
auto operator-=(Left&, const Right&) -> Refused = delete;  // a difference of the same type: r_a -= s_a

template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::InPlace<detail::ProductOf<Left, Right>, Left>
operator*=(Left& left, const Right& right) {
  return left = product(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed<Left> && !detail::LawfulInPlace<detail::ProductOf, Left, Right>)
auto operator*=(Left&, const Right&) -> Refused = delete;  // a product of the same type: r_a *= 2.0

template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::InPlace<detail::QuotientOf<Left, Right>, Left>
operator/=(Left& left, const Right& right) {
  return left = quotient(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed<Left> && !detail::LawfulInPlace<detail::QuotientOf, Left, Right>)
auto operator/=(Left&, const Right&) -> Refused = delete;  // a quotient of the same type: r_a /= 2.0

/// r . s, in the exact product of the units: F . v and tau . w are powers, w . H is an energy.
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::DotOf<Left, Right> dot(const Left& left, const Right& right) {
  return dot_product(left, right);
}
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right> && !detail::Lawful<detail::DotOf, Left, Right>)
auto dot(const Left&, const Right&) -> Refused = delete;  // r_a . s_a: two vectors in one frame

/// r x s, where the radian counts as 1: r x F is a torque, w x r a velocity, w x H a torque.
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right>)
detail::CrossOf<Left, Right> cross(const Left& left, const Right& right) {
  return cross_product(left, right);
}
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right> && !detail::Lawful<detail::CrossOf, Left, Right>)
auto cross(  // r_a x s_a, w_ab_a x r_a: expressed in one frame
    const Left&, const Right&) -> Refused = delete;

}  // namespace vectrix
