#pragma once

#include <Eigen/Core>
#include <vectrix/frames/vector.hpp>

namespace vectrix {
namespace detail {

template <class S> using Square = Eigen::Matrix<S, 3, 3>;

/// A 3x3 matrix of a scalar type that can hold a cosine: not of integers. A matrix or block whose size is
/// known at run time is taken too; the doors call require_size().
template <class M>
concept Matrix3x3 = std::is_base_of_v<Eigen::MatrixBase<M>, M> && may_be<3, M::RowsAtCompileTime> &&
    may_be<3, M::ColsAtCompileTime> && !std::is_integral_v<typename M::Scalar>;

/// The tolerance of a checked door, at least 16 epsilons of S.
template <class S> double door_tolerance(double wanted) {
  const double rounding = 16 * static_cast<double>(Eigen::NumTraits<S>::epsilon());
  return wanted > rounding ? wanted : rounding;
}

/// Copies column by column, in the access widths of the matrix product that writes and of the vector product
/// that reads.
template <class S> [[gnu::always_inline]] inline void set_by_columns(Square<S>& to, const Square<S>& from) {
  for (int column = 0; column < 3; ++column) to.col(column) = from.col(column);
}

}  // namespace detail

template <Frame ToFrame, Frame FromFrame, std::size_t N, class S> class DcmChain;

/// R_a^b, `R_b_from_a`, of type Dcm<B, A>: the direction cosine matrix that takes coordinates in a to
/// coordinates in b:
///     1.  r^b = R_a^b r^a                     R_b_from_a * r_a
///     2.  R_a^c = R_b^c R_a^b                 R_c_from_b * R_b_from_a, a DcmChain
///     3.  R_b^a = (R_a^b)^-1 = (R_a^b)^T      inverse(R_b_from_a)
/// Column i is the i-th basis vector of a in b's coordinates. Made by the doors in dcm_doors.hpp; there is no
/// default.
template <Frame ToFrame, Frame FromFrame, class S = double> class Dcm {
 public:
  using to = ToFrame;
  using from = FromFrame;
  using scalar = S;

  Dcm() = delete;  // dcm(to<B>, from<A>, matrix), or aligned(to<B>, from<A>)
  template <class Derived> Dcm(detail::Trusted, const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {}
  template <detail::Makes<detail::Square<S>> Make> Dcm(detail::Trusted, const Make& make) : matrix_(make()) {}
  template <std::size_t N> [[gnu::always_inline]] Dcm(DcmChain<ToFrame, FromFrame, N, S>&& chain) {
    detail::set_by_columns(matrix_, chain.matrix_);
  }

  /// The bare 3x3 matrix. The frames are no longer checked.
  const detail::Square<S>& matrix() const& { return matrix_; }
  detail::Square<S> matrix() && { return matrix_; }

  template <class Operand = Dcm>
  auto operator-() const -> Refused = delete;  // a rotation has no negative: inverse(R_b_from_a)
  template <class Operand = Dcm>
  auto transpose() const -> Refused = delete;  // its frames change places: inverse(R_b_from_a)

 private:
  detail::Square<S> matrix_;
};

template <class B, class A, class S> inline constexpr bool detail::is_framed<Dcm<B, A, S>> = true;

namespace detail {
// R_a^c = R_b^c R_a^b as a Dcm, without a chain
template <class C, class B, class A, class S>
Dcm<C, A, S> composed(const Dcm<C, B, S>& R_c_from_b, const Dcm<B, A, S>& R_b_from_a) {
  return {trusted, R_c_from_b.matrix() * R_b_from_a.matrix()};
}
}  // namespace detail

// r^b = R_a^b r^a
template <class B, class A, class U, class S>
Vector<B, U, S> product(const Dcm<B, A, S>& R_b_from_a, const Vector<A, U, S>& r_a) {
  return {detail::trusted, R_b_from_a.matrix() * r_a.coordinates()};
}

// R_b^a = (R_a^b)^T
template <class B, class A, class S> Dcm<A, B, S> inverse(const Dcm<B, A, S>& R_b_from_a) {
  return {detail::trusted, R_b_from_a.matrix().transpose()};
}

/// Turns a vector, within a, by the rotation that turns frame a onto frame b:
///     r2^a = R_b^a r1^a
/// This is the active use of the matrix; R_a_from_b * r_b is its passive use. The result is expressed in a.
template <class A, class B, class U, class S>
Vector<A, U, S> rotate(const Dcm<A, B, S>& R_a_from_b, const Vector<A, U, S>& r_a) {
  return {detail::trusted, R_a_from_b.matrix() * r_a.coordinates()};
}
template <class DcmTo, class DcmFrom, class VectorIn, class U, class S>
  requires(!std::same_as<DcmTo, VectorIn>)
auto rotate(  // rotate(R_a_from_b, r_a): r is turned within a
    const Dcm<DcmTo, DcmFrom, S>&, const Vector<VectorIn, U, S>&) -> Refused = delete;

template <class B, class A, class S>
std::ostream& print_framed(std::ostream& out, const Dcm<B, A, S>& R_b_from_a) {
  return detail::print_square(out, R_b_from_a.matrix()) << detail::print_to_from<B, A>;
}

}  // namespace vectrix
