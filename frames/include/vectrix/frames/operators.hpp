#pragma once

namespace vectrix {
namespace detail {

/// Types whose products and sums the frames decide. Each is named beside its class.
template <class T> inline constexpr bool is_framed = false;

template <class Left, class Right>
inline constexpr bool has_product = requires(const Left& left, const Right& right) {
  product(left, right);
};
template <class Left, class Right>
inline constexpr bool has_sum = requires(const Left& left, const Right& right) {
  sum(left, right);
};
template <class Left, class Right>
inline constexpr bool has_difference = requires(const Left& left, const Right& right) {
  difference(left, right);
};
template <class Operand> inline constexpr bool has_negative = requires(const Operand& operand) {
  negative(operand);
};
template <class Left, class Right> inline constexpr bool is_framed_pair = is_framed<Left> || is_framed<Right>;
template <class... Operands> inline constexpr bool any_framed = (is_framed<Operands> || ...);

}  // namespace detail

// One operator for all types of the library, so that the compiler that refuses an expression lists two
// candidates and not thirty. What is multiplied with what is said beside each type, by product(), sum(),
// difference() and negative().
template <class Left, class Right>
  requires(detail::has_product<Left, Right>)
auto operator*(const Left& left, const Right& right) {
  return product(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed_pair<Left, Right> && !detail::has_product<Left, Right>)
void operator*(const Left&, const Right&) = delete;  // the inner frames cancel: R_c_from_b * R_b_from_a * r_a

template <class Left, class Right>
  requires(detail::has_sum<Left, Right>)
auto operator+(const Left& left, const Right& right) {
  return sum(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed_pair<Left, Right> && !detail::has_sum<Left, Right>)
void operator+(const Left&, const Right&) = delete;  // one frame and one unit: r_a + s_a, w_ab_c + w_bd_c

template <class Left, class Right>
  requires(detail::has_difference<Left, Right>)
auto operator-(const Left& left, const Right& right) {
  return difference(left, right);
}
template <class Left, class Right>
  requires(detail::is_framed_pair<Left, Right> && !detail::has_difference<Left, Right>)
void operator-(const Left&, const Right&) = delete;  // one frame and one unit: r_a - s_a, w_ab_c + -w_db_c

template <class Operand>
  requires(detail::has_negative<Operand>)
auto operator-(const Operand& operand) {
  return negative(operand);
}

}  // namespace vectrix
