#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <vectrix/frames/dcm.hpp>

namespace vectrix {

/// Largest | |q| - 1 | that the checked doors let in: ten printed digits pass.
inline constexpr double unit_norm_tolerance = 1e-9;

/// q_a^b, `q_b_from_a`, of type Quaternion<B, A>: a unit quaternion (Hamilton's product) that maps
/// coordinates as R_a^b:
///     1.  r^b = q_a^b r^a (q_a^b)*          q_b_from_a * r_a
///     2.  q_a^c = q_b^c q_a^b               q_c_from_b * q_b_from_a
///     3.  q and -q are the same rotation
/// Made from numbers only by doors that name the place of the scalar.
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
                   "; a zero quaternion turns nothing");
  }
  return norm;
}

template <class B, class A, class S>
Quaternion<B, A, S> unit_quaternion(const Eigen::Quaternion<S>& q, const char* door) {
  const S norm = checked_norm<B, A>(q, door);
  const S error = select(norm > S(1), S(norm - S(1)), S(S(1) - norm));
  const double tolerance = door_tolerance<S>(unit_norm_tolerance);
  if (!all(error <= S(tolerance))) {
    throw BadInput(quaternion_door<B, A>(door) + "the norm differs from 1 by " + text(error) +
                   ", tolerance " + text(tolerance) + "; nearest_" + door + "() projects");
  }
  return {trusted, q};
}

}  // namespace detail

/// The checked doors. Throw BadInput when a number is not finite or | |q| - 1 | exceeds unit_norm_tolerance.
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

template <class B, class A, class S> struct NearestQuaternion {
  Quaternion<B, A, S> quaternion;
  /// How far the norm was from 1.
  S distance;
};

/// The projecting doors: q / |q|, and how far |q| was from 1. Throw BadInput for a zero or not finite
/// quaternion.
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, NearestQuaternion<B, A, S>> nearest_quaternion_scalar_first(To<B>, From<A>, S w, S x, S y,
                                                                                S z) {
  using std::abs;
  const Eigen::Quaternion<S> q{w, x, y, z};
  const S norm = detail::checked_norm<B, A>(q, "nearest_quaternion_scalar_first");
  // Scaled first: the square of a tiny or huge component is not a number that can be divided by.
  const Eigen::Matrix<S, 4, 1> scaled = q.coeffs() / q.coeffs().cwiseAbs().maxCoeff();
  const Eigen::Quaternion<S> unit(scaled / scaled.norm());
  return {Quaternion<B, A, S>{detail::trusted, unit}, abs(norm - S(1))};
}
template <class ToFrame, class FromFrame, class W, class X, class Y, class Z>
auto nearest_quaternion_scalar_first(  // to<B>, from<A>: two frames; four numbers of one floating type
    ToFrame, FromFrame, W, X, Y, Z) -> Refused = delete;
template <Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, NearestQuaternion<B, A, S>> nearest_quaternion_scalar_last(To<B>, From<A>, S x, S y, S z,
                                                                               S w) {
  return nearest_quaternion_scalar_first(to<B>, from<A>, w, x, y, z);
}
template <class ToFrame, class FromFrame, class X, class Y, class Z, class W>
auto nearest_quaternion_scalar_last(  // to<B>, from<A>: two frames; four numbers of one floating type
    ToFrame, FromFrame, X, Y, Z, W) -> Refused = delete;

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

/// R_a^b of q_a^b: entries such as 1 - 2 (y^2 + z^2) and 2 (x y - w z).
template <class B, class A, class S> Dcm<B, A, S> dcm(const Quaternion<B, A, S>& q_b_from_a) {
  return {detail::trusted, q_b_from_a.eigen().toRotationMatrix()};
}

namespace detail {

/// A quaternion times a number, one component after the other: four that are stored one by one and loaded in
/// pairs would wait.
template <class S> struct QuaternionMultiple {
  S x, y, z, w;

  bool in_upper_half() const {
    return w != S(0) ? w > S(0) : x != S(0) ? x > S(0) : y != S(0) ? y > S(0) : z > S(0);
  }
  Eigen::Quaternion<S> unit() const {
    using std::sqrt;
    const S scale = S(in_upper_half() ? 1 : -1) / sqrt(x * x + y * y + z * z + w * w);
    return {w * scale, x * scale, y * scale, z * scale};
  }
};

/// 4 q_i q, from the i-th of the vector part's components, which must not be small.
template <Eigen::Index i, class S> QuaternionMultiple<S> multiple_by_diagonal(const Square<S>& m) {
  constexpr Eigen::Index j = (i + 1) % 3;
  constexpr Eigen::Index k = (i + 2) % 3;
  S v[3];
  v[i] = S(1) + m(i, i) - m(j, j) - m(k, k);
  v[j] = m(i, j) + m(j, i);
  v[k] = m(i, k) + m(k, i);
  return {v[0], v[1], v[2], m(k, j) - m(j, k)};
}
template <class S> QuaternionMultiple<S> largest_multiple(const Square<S>& m) {
  const S x = m(0, 0), y = m(1, 1), z = m(2, 2);
  const S trace = x + y + z;
  if (trace > x && trace > y && trace > z) {
    return {m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1), S(1) + trace};
  }
  if (x >= y && x >= z) return multiple_by_diagonal<0>(m);
  return y >= z ? multiple_by_diagonal<1>(m) : multiple_by_diagonal<2>(m);
}

}  // namespace detail

/// q_a^b of R_a^b, with q_w >= 0, and at q_w = 0 the first non-zero of x, y, z positive. Accurate for every
/// rotation: the largest of the four components is taken from the diagonal (Shepperd 1978), the others by
/// division.
template <class B, class A, class S> Quaternion<B, A, S> quaternion(const Dcm<B, A, S>& R_b_from_a) {
  return {detail::trusted, detail::largest_multiple<S>(R_b_from_a.matrix()).unit()};
}

/// Of a batch: every component's formula is computed and one chosen lane by lane.
template <class B, class A, detail::Batch S> Quaternion<B, A, S> quaternion(const Dcm<B, A, S>& R_b_from_a) {
  using Four = Eigen::Matrix<S, 4, 1>;
  const auto& m = R_b_from_a.matrix();
  const S w = S(1) + m.trace();
  const S x = S(1) + m(0, 0) - m(1, 1) - m(2, 2);
  const S y = S(1) + m(1, 1) - m(2, 2) - m(0, 0);
  const S z = S(1) + m(2, 2) - m(0, 0) - m(1, 1);
  const S wx = m(2, 1) - m(1, 2), wy = m(0, 2) - m(2, 0), wz = m(1, 0) - m(0, 1);
  const S xy = m(0, 1) + m(1, 0), xz = m(0, 2) + m(2, 0), yz = m(1, 2) + m(2, 1);
  const auto either = [](const auto& holds, const Four& yes, const Four& no) {
    using detail::select;
    return Four{select(holds, yes(0), no(0)), select(holds, yes(1), no(1)), select(holds, yes(2), no(2)),
                select(holds, yes(3), no(3))};
  };
  const Four y_or_z = either(m(1, 1) >= m(2, 2), Four{xy, y, yz, wy}, Four{xz, yz, z, wz});
  const S larger = detail::select(m(1, 1) >= m(2, 2), m(1, 1), m(2, 2));
  const Four by_diagonal = either(m(0, 0) >= larger, Four{x, xy, xz, wx}, y_or_z);
  const S largest = detail::select(m(0, 0) >= larger, m(0, 0), larger);
  const Four q = either(m.trace() > largest, Four{wx, wy, wz, w}, by_diagonal);
  const auto or_else = [](const S& first, const S& second) {
    return detail::select(first != S(0), first, second);
  };
  const S sign = or_else(q(3), or_else(q(0), or_else(q(1), q(2))));
  const S norm = q.norm();
  return {detail::trusted, Eigen::Quaternion<S>(q / detail::select<S>(sign < S(0), -norm, norm))};
}

template <class B, class A, class S>
std::ostream& print_framed(std::ostream& out, const Quaternion<B, A, S>& q_b_from_a) {
  return detail::print_quaternion(out, q_b_from_a.eigen()) << detail::print_to_from<B, A>;
}

}  // namespace vectrix
