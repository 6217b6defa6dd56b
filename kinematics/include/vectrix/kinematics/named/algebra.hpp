#pragma once

#include <vectrix/kinematics/named/law.hpp>

namespace vectrix {

// The algebra of frames/vector.hpp, frames/relative_vector.hpp and attitude/quaternion.hpp for frames known
// at run time: the same laws and errors. Two frames where one is needed throw BadInput that names both.

// k r^a and r^a / k
template <class U> NamedVector<U> product(double k, const NamedVector<U>& r_a) {
  return detail::of_one(
      "product", [&](const auto& r) { return k * r; }, r_a);
}
template <class U> NamedVector<U> product(const NamedVector<U>& r_a, double k) {
  return detail::of_one(
      "product", [&](const auto& r) { return r * k; }, r_a);
}
template <class U> NamedVector<U> quotient(const NamedVector<U>& r_a, double k) {
  return detail::of_one(
      "quotient", [&](const auto& r) { return r / k; }, r_a);
}
template <class V, class U>
NamedVector<unit_of_scaled_vector<unit_product<V, U>, U>> product(const Quantity<V>& k,
                                                                  const NamedVector<U>& r_a) {
  return detail::of_one(
      "product", [&](const auto& r) { return k * r; }, r_a);
}
template <class V, class U>
NamedVector<unit_of_scaled_vector<unit_product<U, V>, U>> product(const NamedVector<U>& r_a,
                                                                  const Quantity<V>& k) {
  return detail::of_one(
      "product", [&](const auto& r) { return r * k; }, r_a);
}
template <class V, class U>
NamedVector<unit_of_scaled_vector<unit_quotient<U, V>, U>> quotient(const NamedVector<U>& r_a,
                                                                    const Quantity<V>& k) {
  return detail::of_one(
      "quotient", [&](const auto& r) { return r / k; }, r_a);
}
// k w_ab^c with a gain k, as of a damper
template <detail::GainOfRate V> auto product(const Quantity<V>& k, const NamedAngularVelocity& w_ab) {
  return detail::of_one(
      "product", [&](const auto& w) { return k * w; }, w_ab);
}

// r . s and r x s, also with a rate
template <class U, class V>
Quantity<unit_product<U, V>> dot_product(const NamedVector<U>& r_a, const NamedVector<V>& s_a) {
  using namespace detail::letters;
  return typed_law<Law<Vector<A, U>, Vector<A, V>>>(
      "dot", [](const auto&... x) { return dot(x...); }, r_a, s_a);
}
template <class U>
Quantity<unit_product<si::angular_velocity, U>> dot_product(const NamedAngularVelocity& w_ab_c,
                                                            const NamedVector<U>& r_c) {
  using namespace detail::letters;
  return typed_law<Law<AngularVelocity<A, B, In<C>>, Vector<C, U>>>(
      "dot", [](const auto&... x) { return dot(x...); }, w_ab_c, r_c);
}
template <class U>
Quantity<unit_product<U, si::angular_velocity>> dot_product(const NamedVector<U>& r_c,
                                                            const NamedAngularVelocity& w_ab_c) {
  return dot_product(w_ab_c, r_c);
}
template <class U, class V>
NamedVector<unit_of_vector_product<U, V>> cross_product(const NamedVector<U>& r_a,
                                                        const NamedVector<V>& s_a) {
  using namespace detail::letters;
  return typed_law<Law<Vector<A, U>, Vector<A, V>>>(
      "cross", [](const auto&... x) { return cross(x...); }, r_a, s_a);
}
template <class U>
NamedVector<unit_of_vector_product<si::angular_velocity, U>> cross_product(const NamedAngularVelocity& w_ab_c,
                                                                           const NamedVector<U>& r_c) {
  using namespace detail::letters;
  return typed_law<Law<AngularVelocity<A, B, In<C>>, Vector<C, U>>>(
      "cross", [](const auto&... x) { return cross(x...); }, w_ab_c, r_c);
}

namespace detail {

template <class X> inline constexpr bool is_named_vector = NamedPair<X>;
template <class U> inline constexpr bool is_named_vector<NamedVector<U>> = true;
/// A vector in a frame known at run time, of two frames or of none.
template <class X>
concept AnyNamedVector = is_named_vector<X>;

}  // namespace detail

// What angle_between(r_a, s_a) uses of each operand, and of both.
template <class U> const NamedVector<U>& plain(const NamedVector<U>& r) {
  return r;
}
template <detail::NamedPair X> const auto& plain(const X& x_pq) {
  return x_pq.vector();
}
template <class U, class V>
Quantity<si::angle> angle_of(const NamedVector<U>& r_a, const NamedVector<V>& s_a) {
  using namespace detail::letters;
  return typed_law<Law<Vector<A, U>, Vector<A, V>>>(
      "angle_between", [](const auto&... x) { return angle_between(x...); }, r_a, s_a);
}

/// |r|^2, |r| and r / |r|, with the errors of the typed ones; the first two also of a vector of two frames.
template <detail::AnyNamedVector X> auto squared_norm(const X& r_a) {
  return detail::of_one(
      "squared_norm", [](const auto& r) { return squared_norm(r); }, plain(r_a));
}
template <detail::AnyNamedVector X> auto norm(const X& r_a) {
  return detail::of_one(
      "norm", [](const auto& r) { return norm(r); }, plain(r_a));
}
template <class U> NamedVector<si::dimensionless> direction(const NamedVector<U>& r_a) {
  return detail::of_one(
      "direction", [](const auto& r) { return direction(r); }, r_a);
}
/// The zero vector of a frame, and the unit vectors along its axes.
template <VectorUnit U> NamedVector<U> zero(In<NamedFrame> a) {
  return {detail::trusted, a.frame, detail::Column<double>::Zero()};
}
inline NamedVector<si::dimensionless> unit_x(In<NamedFrame> a) {
  return {detail::trusted, a.frame, detail::Column<double>::UnitX()};
}
inline NamedVector<si::dimensionless> unit_y(In<NamedFrame> a) {
  return {detail::trusted, a.frame, detail::Column<double>::UnitY()};
}
inline NamedVector<si::dimensionless> unit_z(In<NamedFrame> a) {
  return {detail::trusted, a.frame, detail::Column<double>::UnitZ()};
}

// chain(alpha_ab_c, alpha_bd_c, w_ab_c, w_bd_c)
inline NamedAngularAcceleration chained(const NamedAngularAcceleration& alpha_ab_c,
                                        const NamedAngularAcceleration& alpha_bd_c,
                                        const NamedAngularVelocity& w_ab_c,
                                        const NamedAngularVelocity& w_bd_c) {
  using namespace detail::letters;
  return typed_law<Law<AngularAcceleration<A, B, In<C>>, AngularAcceleration<B, D, In<C>>,
                       AngularVelocity<A, B, In<C>>, AngularVelocity<B, D, In<C>>>>(
      "chain", [](const auto&... x) { return chain(x...); }, alpha_ab_c, alpha_bd_c, w_ab_c, w_bd_c);
}

// q_a^c = q_b^c q_a^b, r^b = q_a^b r^a (q_a^b)*, and the same of w and alpha
inline NamedQuaternion product(const NamedQuaternion& q_c_from_b, const NamedQuaternion& q_b_from_a) {
  using namespace detail::letters;
  return typed_law<Law<Quaternion<C, B>, Quaternion<B, A>>>(
      "product", [](const auto& q, const auto& p) { return q * p; }, q_c_from_b, q_b_from_a);
}
template <class U> NamedVector<U> product(const NamedQuaternion& q_b_from_a, const NamedVector<U>& r_a) {
  using namespace detail::letters;
  return typed_law<Law<Quaternion<B, A>, Vector<A, U>>>(
      "product", [](const auto& q, const auto& r) { return q * r; }, q_b_from_a, r_a);
}
inline NamedAngularVelocity product(const NamedQuaternion& q_d_from_c, const NamedAngularVelocity& w_ab_c) {
  using namespace detail::letters;
  return typed_law<Law<Quaternion<D, C>, AngularVelocity<A, B, In<C>>>>(
      "product", [](const auto& q, const auto& w) { return q * w; }, q_d_from_c, w_ab_c);
}
inline NamedAngularAcceleration product(const NamedQuaternion& q_d_from_c,
                                        const NamedAngularAcceleration& alpha_ab_c) {
  using namespace detail::letters;
  return typed_law<Law<Quaternion<D, C>, AngularAcceleration<A, B, In<C>>>>(
      "product", [](const auto& q, const auto& alpha) { return q * alpha; }, q_d_from_c, alpha_ab_c);
}
inline NamedQuaternion inverse(const NamedQuaternion& q_b_from_a) {
  return detail::of_one(
      "inverse", [](const auto& q) { return inverse(q); }, q_b_from_a);
}

/// Turns a vector, within a, by the rotation that turns frame a onto frame b: r2^a = R_b^a r1^a.
template <class U> NamedVector<U> rotate(const NamedDcm& R_a_from_b, const NamedVector<U>& r_a) {
  using namespace detail::letters;
  return typed_law<Law<Dcm<A, B>, Vector<A, U>>>(
      "rotate", [](const auto&... x) { return rotate(x...); }, R_a_from_b, r_a);
}

/// R_b_from_a from the basis vectors of b given in a, the rows of the matrix. Throws BadInput as dcm() does.
inline NamedDcm dcm_from_axes(To<NamedFrame> b, const NamedVector<si::dimensionless>& x_a,
                              const NamedVector<si::dimensionless>& y_a,
                              const NamedVector<si::dimensionless>& z_a) {
  using namespace detail::letters;
  detail::require_two("dcm_from_axes", b.frame, x_a.in());
  using Axis = Vector<A, si::dimensionless>;
  return typed_law<Law<To<B>, Axis, Axis, Axis>>(
      "dcm_from_axes", [](const auto&... x) { return dcm_from_axes(x...); }, b, x_a, y_a, z_a);
}

/// Claims of zero: b does not turn relative to a, or at a constant rate; q is at p, at rest or unaccelerated
/// relative to it, as a sees it.
inline NamedAngularVelocity at_rest(Of<NamedFrame> b, RelativeTo<NamedFrame> a, In<NamedFrame> c) {
  return angular_velocity(b, a, zero<si::angular_velocity>(c));
}
inline NamedAngularAcceleration unaccelerated(Of<NamedFrame> b, RelativeTo<NamedFrame> a, In<NamedFrame> c) {
  return angular_acceleration(b, a, zero<si::angular_acceleration>(c));
}
inline NamedDisplacement coincident(Of<NamedFrame> q, RelativeTo<NamedFrame> p, In<NamedFrame> c) {
  return displacement(q, p, zero<si::length>(c));
}
inline NamedVelocity at_rest(Of<NamedFrame> q, RelativeTo<NamedFrame> p, ObservedFrom<NamedFrame> a,
                             In<NamedFrame> c) {
  return velocity(q, p, a, zero<si::velocity>(c));
}
inline NamedAcceleration unaccelerated(Of<NamedFrame> q, RelativeTo<NamedFrame> p, ObservedFrom<NamedFrame> a,
                                       In<NamedFrame> c) {
  return acceleration(q, p, a, zero<si::acceleration>(c));
}

}  // namespace vectrix
