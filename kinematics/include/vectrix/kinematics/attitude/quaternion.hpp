#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/scalar/square_root.hpp>

namespace vectrix {

/// q_a^b, `q_b_from_a`, of type Quaternion<B, A>: a unit quaternion (Hamilton's product) that maps
/// coordinates as R_a^b:
///     1.  r^b = q_a^b r^a (q_a^b)*          q_b_from_a * r_a
///     2.  q_a^c = q_b^c q_a^b               q_c_from_b * q_b_from_a
///     3.  q and -q are the same rotation
/// Made from numbers only by doors whose name says where the scalar is, and kept as given. In a product the
/// errors of the norms add, with a rounding for each: up to unit_norm_tolerance of a checked door's, a few
/// roundings of exp(), quaternion(R_b_from_a) and the nearest_ doors. No operation checks the norm again;
/// nearest_quaternion() takes the numbers of any product. advance() takes the norm back to 1 at each step.
template <Frame ToFrame, Frame FromFrame, class S = double> class Quaternion {
 public:
  using to = ToFrame;
  using from = FromFrame;

  Quaternion() = delete;
  Quaternion(S, S, S, S) = delete;  // where is the scalar? quaternion_scalar_first(), _last()
  Quaternion(detail::Trusted, const Eigen::Quaternion<S>& value) : value_(value) {}
  template <detail::Makes<Eigen::Quaternion<S>> Make>
  Quaternion(detail::Trusted, const Make& make) : value_(make()) {}

  /// The bare quaternion; Eigen stores the scalar last and constructs with the scalar first.
  const Eigen::Quaternion<S>& eigen() const& { return value_; }
  Eigen::Quaternion<S> eigen() && { return value_; }
  std::array<S, 4> scalar_first() const { return {value_.w(), value_.x(), value_.y(), value_.z()}; }
  std::array<S, 4> scalar_last() const { return {value_.x(), value_.y(), value_.z(), value_.w()}; }

  template <class Operand = Quaternion>
  auto operator-() const -> Refused = delete;  // -q is the same rotation: inverse(q_b_from_a)

 private:
  Eigen::Quaternion<S> value_;
};

template <class B, class A, class S> inline constexpr bool detail::is_framed<Quaternion<B, A, S>> = true;

namespace detail {

/// Of q and -q, which are the same rotation, the library takes the one with q_w >= 0. At q_w = 0 the first
/// non-zero of x, y and z is positive. Returns whether that one is -q.
template <class S> auto is_longer_way(const Eigen::Quaternion<S>& q) {
  const S first = select<S>(q.x() != S(0), q.x(), select<S>(q.y() != S(0), q.y(), q.z()));
  return q.w() < S(0) || (q.w() == S(0) && first < S(0));
}

template <class B, class A> std::string quaternion_door(const char* door) {
  return std::string{door} + "(to<" + frame_name<B>() + ">, from<" + frame_name<A>() + ">): ";
}

template <class B, class A, class S> S checked_norm(const Eigen::Quaternion<S>& q, const char* door) {
  if (!all_finite(q.coeffs())) {
    throw BadInput(quaternion_door<B, A>(door) + "the numbers, scalar first, (" + text(q.w()) + ", " +
                   text(q.x()) + ", " + text(q.y()) + ", " + text(q.z()) + ") are not finite");
  }
  const S norm = scaled_norm(q.coeffs());
  if (!all(norm > S(0)) || !all(norm - norm == S(0))) {
    throw BadInput(quaternion_door<B, A>(door) + "the norm is " + text(norm) +
                   (all(norm > S(0)) ? "; the numbers are too large" : "; a zero quaternion turns nothing"));
  }
  return norm;
}

template <class B, class A, class S>
Quaternion<B, A, S> unit_quaternion(const Eigen::Quaternion<S>& q, const char* door) {
  const S norm = checked_norm<B, A>(q, door);
  const S error = select(norm > S(1), S(norm - S(1)), S(S(1) - norm));
  const double tolerance = door_tolerance<S>(unit_norm_tolerance);
  if (!all(error <= number<S>(tolerance))) {
    throw BadInput(quaternion_door<B, A>(door) + "the norm differs from 1 by " + text(error) +
                   ", tolerance " + text(tolerance) + "; nearest_" + door + "() projects");
  }
  return {trusted, q};
}

}  // namespace detail

/// The checked doors: the numbers are kept as given. Throw BadInput when a number is not finite or | |q| - 1
/// | exceeds unit_norm_tolerance.
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, Quaternion<B, A, S>> quaternion_scalar_first(To<B>, From<A>, S w, S x, S y, S z) {
  return detail::unit_quaternion<B, A, S>({w, x, y, z}, "quaternion_scalar_first");
}
template <class ToFrame, class FromFrame, class W, class X, class Y, class Z>
auto quaternion_scalar_first(  // to<B>, from<A>: two frames; four numbers of one floating type
    ToFrame, FromFrame, W, X, Y, Z) -> Refused = delete;
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, Quaternion<B, A, S>> quaternion_scalar_last(To<B>, From<A>, S x, S y, S z, S w) {
  return detail::unit_quaternion<B, A, S>({w, x, y, z}, "quaternion_scalar_last");
}
template <class ToFrame, class FromFrame, class X, class Y, class Z, class W>
auto quaternion_scalar_last(  // to<B>, from<A>: two frames; four numbers of one floating type
    ToFrame, FromFrame, X, Y, Z, W) -> Refused = delete;

/// The same of Eigen's quaternion, whose members say where the scalar is.
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, Quaternion<B, A, S>> quaternion(To<B>, From<A>, const Eigen::Quaternion<S>& q) {
  return detail::unit_quaternion<B, A, S>(q, "quaternion");
}
template <class ToFrame, class FromFrame, class Given>
auto quaternion(  // to<B>, from<A>: two frames; Eigen's quaternion, or quaternion_scalar_first(), _last()
    To<ToFrame>, From<FromFrame>, const Given&) -> Refused = delete;

template <class B, class A, class S> struct NearestQuaternion {
  Quaternion<B, A, S> quaternion;
  /// | |q| - 1 | before the projection.
  S distance;
};

namespace detail {

template <class B, class A, class S>
NearestQuaternion<B, A, S> nearest_quaternion(const Eigen::Quaternion<S>& q, const char* door) {
  using std::abs;
  const S norm = checked_norm<B, A>(q, door);
  // Scaled first: the square of a tiny or huge component underflows or overflows.
  const Eigen::Matrix<S, 4, 1> scaled = q.coeffs() / q.coeffs().cwiseAbs().maxCoeff();
  const Eigen::Quaternion<S> unit(scaled / scaled.norm());
  return {Quaternion<B, A, S>{trusted, unit}, abs(norm - S(1))};
}

}  // namespace detail

/// The projected doors: q / |q|, and | |q| - 1 |. Throw BadInput when q is zero or not finite.
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, NearestQuaternion<B, A, S>> nearest_quaternion_scalar_first(To<B>, From<A>, S w, S x, S y,
                                                                                S z) {
  return detail::nearest_quaternion<B, A, S>({w, x, y, z}, "nearest_quaternion_scalar_first");
}
template <class ToFrame, class FromFrame, class W, class X, class Y, class Z>
auto nearest_quaternion_scalar_first(  // to<B>, from<A>: two frames; four numbers of one floating type
    ToFrame, FromFrame, W, X, Y, Z) -> Refused = delete;
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, NearestQuaternion<B, A, S>> nearest_quaternion_scalar_last(To<B>, From<A>, S x, S y, S z,
                                                                               S w) {
  return detail::nearest_quaternion<B, A, S>({w, x, y, z}, "nearest_quaternion_scalar_last");
}
template <class ToFrame, class FromFrame, class X, class Y, class Z, class W>
auto nearest_quaternion_scalar_last(  // to<B>, from<A>: two frames; four numbers of one floating type
    ToFrame, FromFrame, X, Y, Z, W) -> Refused = delete;

template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, NearestQuaternion<B, A, S>> nearest_quaternion(To<B>, From<A>,
                                                                   const Eigen::Quaternion<S>& q) {
  return detail::nearest_quaternion<B, A, S>(q, "nearest_quaternion");
}
template <class ToFrame, class FromFrame, class Given>
auto nearest_quaternion(  // to<B>, from<A>: two frames; Eigen's quaternion
    To<ToFrame>, From<FromFrame>, const Given&) -> Refused = delete;

// q_a^c = q_b^c q_a^b
template <class C, class B, class A, class S>
Quaternion<C, A, S> product(const Quaternion<C, B, S>& q_c_from_b, const Quaternion<B, A, S>& q_b_from_a) {
  return {detail::trusted, [&] { return q_c_from_b.eigen() * q_b_from_a.eigen(); }};
}

// r^b = q r^a q*
template <class B, class A, class U, class S>
Vector<B, U, S> product(const Quaternion<B, A, S>& q_b_from_a, const Vector<A, U, S>& r_a) {
  return {detail::trusted, [&] { return q_b_from_a.eigen()._transformVector(r_a.coordinates()); }};
}

template <class B, class A, class S> Quaternion<A, B, S> inverse(const Quaternion<B, A, S>& q_b_from_a) {
  return {detail::trusted, q_b_from_a.eigen().conjugate()};
}

/// R_a^b of q_a^b: entries such as 1 - 2 (y^2 + z^2) and 2 (x y - w z). At |q| = 1 + d the entries of
/// R^T R - I are up to 8 d.
template <class B, class A, class S> Dcm<B, A, S> dcm(const Quaternion<B, A, S>& q_b_from_a) {
  return {detail::trusted, [&] { return q_b_from_a.eigen().toRotationMatrix(); }};
}

namespace detail {

/// A quaternion times a number, in four scalars. Stored one by one in an array and loaded in pairs, they
/// would cause a store-forwarding stall.
template <class S> struct QuaternionMultiple {
  S x, y, z, w;

  /// Divided by its norm, times the sign.
  [[gnu::always_inline]] Eigen::Quaternion<S> unit(const S& sign) const {
    if constexpr (std::same_as<S, double>) {
      using Two = double __attribute__((vector_size(16)));
      const Two xy{x, y}, zw{z, w};
      const Two squares = xy * xy + zw * zw;
      const double scale = sign / square_root(squares[0] + squares[1]);
      const Two unit_xy = xy * Two{scale, scale}, unit_zw = zw * Two{scale, scale};
      return {unit_zw[1], unit_xy[0], unit_xy[1], unit_zw[0]};
    } else {
      const S scale = sign / square_root(S(x * x + y * y + z * z + w * w));
      return {w * scale, x * scale, y * scale, z * scale};
    }
  }
  /// The sign of the first non-zero of w, x, y, z.
  [[gnu::always_inline]] S sign() const {
    if constexpr (Batch<S>) {
      const S first = select(w != S(0), w, select(x != S(0), x, y));  // else z, the largest and positive
      return select(first < S(0), S(-1), S(1));
    } else {
      return S((w != S(0) ? w > S(0) : x != S(0) ? x > S(0) : y != S(0) ? y > S(0) : z > S(0)) ? 1 : -1);
    }
  }
};

/// 4 q_i q, where q_i is the i-th component of the vector part. It must not be small.
template <Eigen::Index i, class S> QuaternionMultiple<S> multiple_by_diagonal(const Square<S>& m) {
  constexpr Eigen::Index j = (i + 1) % 3;
  constexpr Eigen::Index k = (i + 2) % 3;
  S v[3];
  v[i] = (S(1) + m(i, i)) - (m(j, j) + m(k, k));
  v[j] = m(i, j) + m(j, i);
  v[k] = m(i, k) + m(k, i);
  return {v[0], v[1], v[2], m(k, j) - m(j, k)};
}
template <class S> QuaternionMultiple<S> multiple_by_trace(const Square<S>& m) {
  return {m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1), (S(1) + m(0, 0)) + (m(1, 1) + m(2, 2))};
}
template <class S> QuaternionMultiple<S> largest_by_diagonal(const Square<S>& m) {
  const S x = m(0, 0), y = m(1, 1), z = m(2, 2);
  if (x >= y && x >= z) return multiple_by_diagonal<0>(m);
  return y >= z ? multiple_by_diagonal<1>(m) : multiple_by_diagonal<2>(m);
}
template <class S> Eigen::Quaternion<S> unit_quaternion_of(const Square<S>& m) {
  if (m(0, 0) + m(1, 1) + m(2, 2) > S(0)) return multiple_by_trace(m).unit(S(1));
  const QuaternionMultiple<S> q = largest_by_diagonal(m);
  return q.unit(q.sign());
}
/// For a batch, two choices in each lane: the pair (w, x) or (y, z) that holds at least half of |q|^2, then
/// the larger component of that pair.
template <Batch S> [[gnu::always_inline]] inline Eigen::Quaternion<S> unit_quaternion_of(const Square<S>& m) {
  const S x = m(0, 0), y = m(1, 1), z = m(2, 2);
  const S wx = m(2, 1) - m(1, 2), wy = m(0, 2) - m(2, 0), wz = m(1, 0) - m(0, 1);
  const S xy = m(1, 0) + m(0, 1), xz = m(0, 2) + m(2, 0), yz = m(2, 1) + m(1, 2);
  const auto w_or_x = x >= S(0);
  const S rest = select(w_or_x, S(y + z), S(y - z));
  const auto w_or_y = rest >= S(0);
  using std::abs;
  const S large = S(1) + abs(x) + abs(rest);
  const S other = select(w_or_x, wx, yz);
  const S first = select(w_or_y, large, other), second = select(w_or_y, other, large);
  const S third = select(w_or_y, wy, select(w_or_x, xy, wz));
  const S fourth = select(w_or_y, select(w_or_x, wz, xy), xz);
  const QuaternionMultiple<S> q{select(w_or_x, second, fourth), select(w_or_x, third, first),
                                select(w_or_x, fourth, second), select(w_or_x, first, third)};
  return q.unit(q.sign());
}

}  // namespace detail

/// q_a^b of R_a^b, with q_w >= 0, and at q_w = 0 the first non-zero of x, y, z positive. Accurate for every
/// rotation: a component of at least 1/2 is computed from the diagonal (after Shepperd 1978), the others by
/// division.
template <class B, class A, class S> Quaternion<B, A, S> quaternion(const Dcm<B, A, S>& R_b_from_a) {
  return {detail::trusted, [&] { return detail::unit_quaternion_of<S>(R_b_from_a.matrix()); }};
}

template <class B, class A, class S>
std::ostream& print_framed(std::ostream& out, const Quaternion<B, A, S>& q_b_from_a) {
  return detail::print_quaternion(out, q_b_from_a.eigen()) << detail::print_to_from<B, A>;
}

}  // namespace vectrix
