#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vectrix/frames/relative_vector.hpp>
#include <vectrix/frames/scalar/column_pair.hpp>

namespace vectrix {
namespace detail {

/// A rotation in a chain. It is copied by columns, in the width that a vector product reads, so that the
/// compiler removes the copies.
template <class S> class Factor {
 public:
  [[gnu::always_inline]] explicit Factor(const Square<S>& matrix) { set_by_columns(matrix_, matrix); }
  [[gnu::always_inline]] Factor(const Factor& other) { set_by_columns(matrix_, other.matrix_); }
  Factor& operator=(const Factor&) = default;

  const Square<S>& matrix() const { return matrix_; }

 private:
  Square<S> matrix_;
};

template <class S> using OneFactor = std::array<Factor<S>, 1>;

template <class S, std::size_t N, std::size_t M, std::size_t... I, std::size_t... J>
[[gnu::always_inline]] inline std::array<Factor<S>, N + M> joined(const std::array<Factor<S>, N>& left,
                                                                  const std::array<Factor<S>, M>& right,
                                                                  std::index_sequence<I...>,
                                                                  std::index_sequence<J...>) {
  return {left[I]..., right[J]...};
}

}  // namespace detail

/// R_a^d = R_c^d R_b^c R_a^b: the result of a product of N rotations. It is a Dcm<D, A>. A temporary chain is
/// applied to a vector from right to left:
///     R_d_from_c * R_c_from_b * R_b_from_a * r_a      three matrix-vector products, no matrix product
/// A named chain, `auto R_d_from_a = ...`, is the Dcm, multiplied once. A chain holds copies of its factors,
/// so it never dangles. It cannot be moved, because a named chain may have been assigned another rotation. To
/// return it or to store only the matrix, give it a type: `Dcm<D, A> R_d_from_a = ...`. After eight rotations
/// the product so far becomes one factor. A product departs from a rotation by the errors of its factors, up
/// to orthonormality_tolerance of what dcm() took, and a rounding for each. No operation checks this again;
/// nearest_dcm() takes the matrix of any product. To carry an attitude on, use advance(), which takes them
/// back at each step.
template <Frame ToFrame, Frame FromFrame, std::size_t N, class S = double>
class DcmChain : public Dcm<ToFrame, FromFrame, S> {
  using Product = Dcm<ToFrame, FromFrame, S>;

 public:
  template <class B, std::size_t L>
  [[gnu::always_inline]] DcmChain(detail::Trusted, const Dcm<ToFrame, B, S>& left,
                                  const std::array<detail::Factor<S>, L>& left_factors,
                                  const Dcm<B, FromFrame, S>& right,
                                  const std::array<detail::Factor<S>, N - L>& right_factors)
      : Product(detail::trusted, left.matrix() * right.matrix()),
        factors_(detail::joined(left_factors, right_factors, std::make_index_sequence<L>{},
                                std::make_index_sequence<N - L>{})) {}
  DcmChain(const DcmChain& named) : DcmChain(static_cast<const Product&>(named)) {}
  DcmChain(DcmChain&&) = delete;  // give the product a type: Dcm<D, A> R_d_from_a = R_d_from_c * R_c_from_a
  DcmChain& operator=(const DcmChain& R_d_from_a) { return *this = static_cast<const Product&>(R_d_from_a); }
  DcmChain& operator=(const Product& R_d_from_a) {
    Product::operator=(R_d_from_a);
    factors_ = alone(R_d_from_a);
    return *this;
  }

  const std::array<detail::Factor<S>, N>& factors() const { return factors_; }

 private:
  explicit DcmChain(const Product& R_d_from_a) : Product(R_d_from_a), factors_(alone(R_d_from_a)) {}
  // One rotation as a chain: itself, then identities.
  static std::array<detail::Factor<S>, N> alone(const Product& R_d_from_a) {
    return alone(R_d_from_a, std::make_index_sequence<N - 1>{});
  }
  template <std::size_t... I>
  static std::array<detail::Factor<S>, N> alone(const Product& R_d_from_a, std::index_sequence<I...>) {
    const detail::Square<S> none = detail::Square<S>::Identity();
    return {detail::Factor<S>{R_d_from_a.matrix()}, (static_cast<void>(I), detail::Factor<S>{none})...};
  }

  std::array<detail::Factor<S>, N> factors_;
};

template <class B, class A, std::size_t N, class S>
inline constexpr bool detail::is_framed<DcmChain<B, A, N, S>> = true;

namespace detail {

template <class B, class A, std::size_t N, class S>
struct EvaluatedType<DcmChain<B, A, N, S>> : std::type_identity<Dcm<B, A, S>> {};

template <class B, class A, class S>
[[gnu::always_inline]] inline OneFactor<S> factors(const Dcm<B, A, S>& R_b_from_a) {
  return {Factor<S>{R_b_from_a.matrix()}};
}

// R1 (R2 (... (Rn x)))
template <std::size_t first = 0, class S, std::size_t N, class X>
[[gnu::always_inline]] inline X turned_by(const std::array<Factor<S>, N>& factors, const X& x) {
  if constexpr (first == N) {
    return x;
  } else {
    return factors[first].matrix() * turned_by<first + 1>(factors, x);
  }
}
template <class S, std::size_t N>
[[gnu::always_inline]] inline Column<S> applied(const std::array<Factor<S>, N>& factors, const Column<S>& x) {
  if constexpr (std::is_same_v<S, double> && !Square<S>::IsRowMajor) {
    return turned_by(factors, ColumnPair(x)).column();
  } else {
    return turned_by(factors, x);
  }
}

/// The longest chain: code size grows with length^2. A longer product continues as a chain of two matrices.
inline constexpr std::size_t longest_chain = 8;

template <class C, class B, class A, std::size_t N, std::size_t M, class S>
[[gnu::always_inline]] inline auto chained(const Dcm<C, B, S>& R_c_from_b,
                                           const std::array<Factor<S>, N>& left_factors,
                                           const Dcm<B, A, S>& R_b_from_a,
                                           const std::array<Factor<S>, M>& right_factors) {
  if constexpr (N + M <= longest_chain) {
    return DcmChain<C, A, N + M, S>{trusted, R_c_from_b, left_factors, R_b_from_a, right_factors};
  } else {
    return DcmChain<C, A, 2, S>{trusted, R_c_from_b, factors(R_c_from_b), R_b_from_a, factors(R_b_from_a)};
  }
}

}  // namespace detail

// R_a^c = R_b^c R_a^b, each side one rotation or a temporary chain
template <class C, class B, class A, class S>
[[gnu::always_inline]] inline DcmChain<C, A, 2, S> product(const Dcm<C, B, S>& R_c_from_b,
                                                           const Dcm<B, A, S>& R_b_from_a) {
  return {detail::trusted, R_c_from_b, detail::factors(R_c_from_b), R_b_from_a, detail::factors(R_b_from_a)};
}
template <class C, class B, class A, std::size_t N, class S>
[[gnu::always_inline]] inline auto product(DcmChain<C, B, N, S>&& R_c_from_b,
                                           const Dcm<B, A, S>& R_b_from_a) {
  return detail::chained(R_c_from_b, R_c_from_b.factors(), R_b_from_a, detail::factors(R_b_from_a));
}
template <class C, class B, class A, std::size_t N, class S>
[[gnu::always_inline]] inline auto product(const Dcm<C, B, S>& R_c_from_b,
                                           DcmChain<B, A, N, S>&& R_b_from_a) {
  return detail::chained(R_c_from_b, detail::factors(R_c_from_b), R_b_from_a, R_b_from_a.factors());
}
template <class C, class B, class A, std::size_t N, std::size_t M, class S>
[[gnu::always_inline]] inline auto product(DcmChain<C, B, N, S>&& R_c_from_b,
                                           DcmChain<B, A, M, S>&& R_b_from_a) {
  return detail::chained(R_c_from_b, R_c_from_b.factors(), R_b_from_a, R_b_from_a.factors());
}

// r^b = R_a^b r^a and x_pq^b = R_a^b x_pq^a, the vector first
template <class B, class A, std::size_t N, class U, class S>
[[gnu::always_inline]] inline Vector<B, U, S> product(DcmChain<B, A, N, S>&& R_b_from_a,
                                                      const Vector<A, U, S>& r_a) {
  return {detail::trusted, detail::applied(R_b_from_a.factors(), r_a.coordinates())};
}
template <class B, class A, std::size_t N, class S, detail::Reexpressed X>
  requires(std::same_as<typename X::expressed, A>&& std::same_as<typename X::scalar, S>)
[[gnu::always_inline]] inline auto product(DcmChain<B, A, N, S>&& R_b_from_a, const X& x_pq_a) {
  return typename X::template Expressed<B>{detail::trusted,
                                           detail::applied(R_b_from_a.factors(), x_pq_a.coordinates())};
}

}  // namespace vectrix
