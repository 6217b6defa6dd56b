#pragma once

#include <vectrix/frames/dcm.hpp>

namespace vectrix {
namespace detail {

/// The base of all quantities of q relative to p: a vector, here x_pq^c, and the laws below. A derived class
/// defines p and q, and by `Between` and `Expressed` the same quantity of other points or in other axes. A
/// quantity of one point p, such as a torque, uses only the change of axes.
template <class C, class U, class S> class RelativeVector {
 public:
  using expressed = C;
  using unit = U;
  using scalar = S;

  explicit RelativeVector(Trusted, const Vector<C, U, S>& vector) : vector_(vector) {}
  template <class Derived>
  explicit RelativeVector(Trusted key, const Eigen::MatrixBase<Derived>& coordinates)
      : vector_(key, coordinates) {}

  const Vector<C, U, S>& vector() const& { return vector_; }
  Vector<C, U, S> vector() && { return vector_; }
  const Column<S>& coordinates() const& { return vector_.coordinates(); }
  Column<S> coordinates() && { return vector_.coordinates(); }

  Quantity<U, S> x() const { return vector_.x(); }
  Quantity<U, S> y() const { return vector_.y(); }
  Quantity<U, S> z() const { return vector_.z(); }

 private:
  Vector<C, U, S> vector_;
};

/// A quantity that can be expressed in another frame.
template <class X>
concept Reexpressed = requires {
  typename X::template Expressed<typename X::expressed>;
};
/// A quantity whose sums chain. Angular accelerations do not: their sum needs the rates.
template <class X>
concept Chained = requires {
  typename X::template Between<typename X::first, typename X::second>;
};

template <class X, class Pair>
using Like = typename X::template Between<typename Pair::first, typename Pair::second>;
/// Both are the same quantity, expressed in the same frame.
template <class Left, class Right>
concept SameQuantity = Chained<Left> && Chained<Right> && std::same_as<Like<Left, Left>, Like<Right, Left>>;

}  // namespace detail

// x_ps^c = x_pq^c + x_qs^c
template <detail::Chained Left, detail::SameQuantity<Left> Right>
  requires std::same_as<typename Left::second, typename Right::first>
auto sum(const Left& x_pq_c, const Right& x_qs_c) {
  return typename Left::template Between<typename Left::first, typename Right::second>{
      detail::trusted, x_pq_c.coordinates() + x_qs_c.coordinates()};
}
// The sum commutes: x_qs^c + x_pq^c chains as well.
template <detail::Chained Left, detail::SameQuantity<Left> Right>
  requires(std::same_as<typename Right::second, typename Left::first> &&
           !std::same_as<typename Left::second, typename Right::first>)
auto sum(const Left& x_qs_c, const Right& x_pq_c) {
  return typename Left::template Between<typename Right::first, typename Left::second>{
      detail::trusted, x_qs_c.coordinates() + x_pq_c.coordinates()};
}

// x_qs^c = x_ps^c - x_pq^c: the common reference goes.
template <detail::Chained Left, detail::SameQuantity<Left> Right>
  requires(std::same_as<typename Left::first, typename Right::first> &&
           !std::same_as<typename Left::second, typename Right::second>)
auto difference(const Left& x_ps_c, const Right& x_pq_c) {
  return typename Left::template Between<typename Right::second, typename Left::second>{
      detail::trusted, x_ps_c.coordinates() - x_pq_c.coordinates()};
}
// x_pq^c = x_ps^c - x_qs^c
template <detail::Chained Left, detail::SameQuantity<Left> Right>
  requires(std::same_as<typename Left::second, typename Right::second> &&
           !std::same_as<typename Left::first, typename Right::first>)
auto difference(const Left& x_ps_c, const Right& x_qs_c) {
  return typename Left::template Between<typename Left::first, typename Right::first>{
      detail::trusted, x_ps_c.coordinates() - x_qs_c.coordinates()};
}
template <detail::Chained Left, detail::SameQuantity<Left> Right>
struct detail::ReasonOf<Left, Right>
    : std::conditional<std::same_as<Left, Right>, reason::one_pair_twice, reason::no_frame_cancels> {};

/// The error of an estimate of x_pq^c, as a plain vector: its coordinates less those of the reference. The
/// difference of two values of one quantity is no quantity of p and q, so that it needs this name.
/// Any finite input is valid.
template <detail::Reexpressed X>
Vector<typename X::expressed, typename X::unit, typename X::scalar> error_between(const X& estimate,
                                                                                  const X& reference) {
  return {detail::trusted, estimate.coordinates() - reference.coordinates()};
}
template <class Estimate, class Reference>
auto error_between(  // error_between(w_ab_c, v_ab_c): two values of one quantity, in one frame
    const Estimate&, const Reference&) -> Refused = delete;

/// |x_pq|^2, in the exact square of the unit.
template <detail::Reexpressed X> auto squared_norm(const X& x_pq_c) {
  return squared_norm(x_pq_c.vector());
}

namespace detail {

template <Reexpressed X> const auto& plain(const X& x_pq_c) {
  return x_pq_c.vector();
}
template <class F, class U, class S> const auto& plain(const Vector<F, U, S>& r) {
  return r;
}
template <class Left, class Right>
using AngleBetween =
    decltype(angle_of(plain(std::declval<const Left&>()), plain(std::declval<const Right&>())));
template <class Left, class Right>
concept HasAngle = requires {
  typename AngleBetween<Left, Right>;
};

}  // namespace detail

/// The angle between two vectors in one frame, from 0 to pi, rad, as accurate near 0 and near pi as in
/// between:
///     2 atan2(|u - v|, |u + v|)    u, v the directions of the two (Kahan)
/// Throws BadInput for a zero vector. Derivatives are NaN for parallel vectors.
template <class Left, class Right>
detail::AngleBetween<Left, Right> angle_between(const Left& r_a, const Right& s_a) {
  using detail::angle_of, detail::plain;
  return angle_of(plain(r_a), plain(s_a));
}
template <class Left, class Right>
  requires(detail::FramedPair<Left, Right> && !detail::HasAngle<Left, Right>)
auto angle_between(const Left&, const Right&) -> Refused = delete;  // angle_between(r_a, s_a): in one frame

// x_pq^d = R_c^d x_pq^c
template <class D, detail::Reexpressed X>
auto product(const Dcm<D, typename X::expressed, typename X::scalar>& R_d_from_c, const X& x_pq_c) {
  return typename X::template Expressed<D>{detail::trusted, R_d_from_c.matrix() * x_pq_c.coordinates()};
}

}  // namespace vectrix
