#pragma once

#include <vectrix/kinematics/named/algebra.hpp>
#include <vectrix/kinematics/points/coincident.hpp>
#include <vectrix/kinematics/points/derivative.hpp>
#include <vectrix/kinematics/points/parallel.hpp>
#include <vectrix/kinematics/samples/hermite.hpp>

namespace vectrix {

// Motions, points and observers for frames known at run time: the words of kinematics/points/ and of
// rates/moving_dcm.hpp, with the same laws. The points are the origins of frames.

/// r_pq^a and v_pq|a^a: PointMotion for frames known at run time.
struct NamedPointMotion {
  NamedDisplacement position;
  NamedVelocity velocity;
};
/// d/dt|_a r^c of a vector in the unit U: Derivative for frames known at run time.
template <VectorUnit U> using NamedDerivative = Named<Derivative<Some<'a'>, Some<'b'>, U>>;

namespace detail {

template <class P, class Q, class A> struct Relabel<PointMotion<P, Q, A>> {
  static PointMotion<P, Q, A> of(const NamedPointMotion& x) {
    return {relabelled<Displacement<P, Q, In<A>>>(x.position),
            relabelled<Velocity<P, Q, ObservedFrom<A>, In<A>>>(x.velocity)};
  }
};
template <class A, class C, class U> struct Relabel<Derivative<A, C, U>> {
  template <class X> static Derivative<A, C, U> of(const X& x) {
    return {trusted, relabelled<Vector<C, typename Derivative<A, C, U>::unit>>(x.vector())};
  }
};

template <>
struct NamedFor<PointMotion<Some<'a'>, Some<'b'>, Some<'c'>>> : std::type_identity<NamedPointMotion> {};
template <> struct Naming<NamedPointMotion> {
  using form = PointMotion<Some<'a'>, Some<'b'>, Some<'c'>>;
  static std::array<NamedFrame, 3> frames(const NamedPointMotion& x) {
    return {x.position.relative_to(), x.position.of(), x.velocity.observed_from()};
  }
  template <class Typed> static NamedPointMotion make(const std::array<NamedFrame, 3>& f, const Typed& x) {
    return {Naming<NamedDisplacement>::make({f[0], f[1], f[2]}, x.position),
            Naming<NamedVelocity>::make({f[0], f[1], f[2], f[2]}, x.velocity)};
  }
};

template <class X>
concept NamedTurning = std::same_as<X, NamedMovingDcm> || std::same_as<X, NamedAcceleratingDcm>;
template <class X>
concept NamedPlacedMotion =
    std::same_as<X, NamedMovingTransform> || std::same_as<X, NamedAcceleratingTransform>;
template <class X>
concept NamedMotion = NamedTurning<X> || NamedPlacedMotion<X>;
/// A motion of b relative to a, and one of d relative to b.
template <template <class, class, class> class Motion>
using ChainOfMotions = Law<Motion<Some<'a'>, Some<'b'>, double>, Motion<Some<'b'>, Some<'d'>, double>>;

}  // namespace detail

// X_ad = X_ab X_bd and X_ba = X_ab^-1, of motions of one level
inline NamedMovingDcm product(const NamedMovingDcm& ab, const NamedMovingDcm& bd) {
  return typed_law<detail::ChainOfMotions<MovingDcm>>(
      "product", [](const auto& x, const auto& y) { return x * y; }, ab, bd);
}
inline NamedAcceleratingDcm product(const NamedAcceleratingDcm& ab, const NamedAcceleratingDcm& bd) {
  return typed_law<detail::ChainOfMotions<AcceleratingDcm>>(
      "product", [](const auto& x, const auto& y) { return x * y; }, ab, bd);
}
inline NamedMovingTransform product(const NamedMovingTransform& ab, const NamedMovingTransform& bd) {
  return typed_law<detail::ChainOfMotions<MovingTransform>>(
      "product", [](const auto& x, const auto& y) { return x * y; }, ab, bd);
}
inline NamedAcceleratingTransform product(const NamedAcceleratingTransform& ab,
                                          const NamedAcceleratingTransform& bd) {
  return typed_law<detail::ChainOfMotions<AcceleratingTransform>>(
      "product", [](const auto& x, const auto& y) { return x * y; }, ab, bd);
}
template <detail::NamedMotion X> X inverse(const X& ab) {
  return detail::of_one(
      "inverse", [](const auto& x) { return inverse(x); }, ab);
}

/// The motion without its accelerations; the rotation and the position alone.
inline NamedMovingDcm without_acceleration(const NamedAcceleratingDcm& ab) {
  return detail::of_one(
      "without_acceleration", [](const auto& x) { return without_acceleration(x); }, ab);
}
inline NamedMovingTransform moving_transform_of(const NamedAcceleratingTransform& ab) {
  return detail::of_one(
      "moving_transform_of", [](const auto& x) { return moving_transform_of(x); }, ab);
}
template <detail::NamedPlacedMotion X> NamedTransform transform_of(const X& ab) {
  return detail::of_one(
      "transform_of", [](const auto& x) { return transform_of(x); }, ab);
}

/// Claims that a and b have the same origin at all times: r_ab = 0, and with a rate v_ab|a = 0, a_ab|a = 0.
inline NamedTransform coincident(const NamedDcm& R_a_from_b) {
  return detail::of_one(
      "coincident", [](const auto& R) { return coincident(R); }, R_a_from_b);
}
inline NamedMovingTransform coincident(const NamedMovingDcm& turning) {
  return detail::of_one(
      "coincident", [](const auto& x) { return coincident(x); }, turning);
}
inline NamedAcceleratingTransform coincident(const NamedAcceleratingDcm& turning) {
  return detail::of_one(
      "coincident", [](const auto& x) { return coincident(x); }, turning);
}

/// Claims that the vectors are the position and the velocity of q relative to p, observed from a.
inline NamedPointMotion point_motion(Of<NamedFrame> q, RelativeTo<NamedFrame> p, ObservedFrom<NamedFrame> a,
                                     const NamedVector<si::length>& r_pq_a,
                                     const NamedVector<si::velocity>& v_pq_a) {
  using namespace detail::letters;
  return typed_law<
      Law<Of<Q>, RelativeTo<P>, ObservedFrom<A>, Vector<A, si::length>, Vector<A, si::velocity>>>(
      "point_motion", [](const auto&... x) { return point_motion(x...); }, q, p, a, r_pq_a, v_pq_a);
}
/// The motion at t in a step h, by the cubic through its start and its end.
inline NamedPointMotion hermite(const NamedPointMotion& start, const NamedPointMotion& end,
                                const Quantity<si::time>& h, const Quantity<si::time>& t) {
  using namespace detail::letters;
  return typed_law<Law<PointMotion<P, Q, A>, PointMotion<P, Q, A>>>(
      "hermite", [&](const auto&... x) { return hermite(x..., h, t); }, start, end);
}
/// Claims that the axes of q are parallel to those of a at all times: the motion of a point as a frame's.
inline NamedMovingTransform parallel(const NamedPointMotion& motion) {
  using namespace detail::letters;
  return typed_law<Law<PointMotion<A, Q, A>>>(
      "parallel", [](const auto& x) { return parallel(x); }, motion);
}
inline NamedAcceleratingTransform parallel(const NamedPointMotion& motion, const NamedAcceleration& a_aq_a) {
  using namespace detail::letters;
  return typed_law<Law<PointMotion<A, Q, A>, Acceleration<A, Q, ObservedFrom<A>, In<A>>>>(
      "parallel", [](const auto&... x) { return parallel(x...); }, motion, a_aq_a);
}

/// Claims that rdot_c is d/dt|_a of a vector in the unit U: derivative<si::length>(ObservedFrom(a), v_c).
template <VectorUnit U>
NamedDerivative<U> derivative(ObservedFrom<NamedFrame> a,
                              const NamedVector<unit_of_vector_quotient<U, si::time>>& rdot_c) {
  using namespace detail::letters;
  return typed_law<Law<ObservedFrom<A>, Vector<C, unit_of_vector_quotient<U, si::time>>>>(
      "derivative", [](const auto&... x) { return derivative<U>(x...); }, a, rdot_c);
}
// transport(ObservedFrom(a), ...) of a derivative, a velocity or an acceleration, seen from b before
template <class U, class C0>
NamedDerivative<U> transported(ObservedFrom<NamedFrame> a, const Named<Derivative<Some<'a'>, C0, U>>& rdot_c,
                               const NamedVector<U>& r_c, const NamedAngularVelocity& w_ab_c) {
  using namespace detail::letters;
  return typed_law<Law<ObservedFrom<A>, Derivative<B, C, U>, Vector<C, U>, AngularVelocity<A, B, In<C>>>>(
      "transport", [](const auto&... x) { return transport(x...); }, a, rdot_c, r_c, w_ab_c);
}
inline NamedVelocity transported(ObservedFrom<NamedFrame> a, const NamedVelocity& v_pq_b_c,
                                 const NamedDisplacement& r_pq_c, const NamedAngularVelocity& w_ab_c) {
  using namespace detail::letters;
  return typed_law<Law<ObservedFrom<A>, Velocity<P, Q, ObservedFrom<B>, In<C>>, Displacement<P, Q, In<C>>,
                       AngularVelocity<A, B, In<C>>>>(
      "transport", [](const auto&... x) { return transport(x...); }, a, v_pq_b_c, r_pq_c, w_ab_c);
}
inline NamedAcceleration transported(ObservedFrom<NamedFrame> a, const NamedAcceleration& a_pq_b_c,
                                     const NamedVelocity& v_pq_b_c, const NamedDisplacement& r_pq_c,
                                     const NamedAngularAcceleration& alpha_ab_c,
                                     const NamedAngularVelocity& w_ab_c) {
  using namespace detail::letters;
  return typed_law<
      Law<ObservedFrom<A>, Acceleration<P, Q, ObservedFrom<B>, In<C>>, Velocity<P, Q, ObservedFrom<B>, In<C>>,
          Displacement<P, Q, In<C>>, AngularAcceleration<A, B, In<C>>, AngularVelocity<A, B, In<C>>>>(
      "transport", [](const auto&... x) { return transport(x...); }, a, a_pq_b_c, v_pq_b_c, r_pq_c,
      alpha_ab_c, w_ab_c);
}

/// The apparent accelerations for an observer in b.
inline NamedVector<si::acceleration> euler_acceleration(const NamedAngularAcceleration& alpha_ab_c,
                                                        const NamedDisplacement& r_pq_c) {
  using namespace detail::letters;
  return typed_law<Law<AngularAcceleration<A, B, In<C>>, Displacement<P, Q, In<C>>>>(
      "euler_acceleration", [](const auto&... x) { return euler_acceleration(x...); }, alpha_ab_c, r_pq_c);
}
inline NamedVector<si::acceleration> coriolis_acceleration(const NamedAngularVelocity& w_ab_c,
                                                           const NamedVelocity& v_pq_b_c) {
  using namespace detail::letters;
  return typed_law<Law<AngularVelocity<A, B, In<C>>, Velocity<P, Q, ObservedFrom<B>, In<C>>>>(
      "coriolis_acceleration", [](const auto&... x) { return coriolis_acceleration(x...); }, w_ab_c,
      v_pq_b_c);
}
inline NamedVector<si::acceleration> centrifugal_acceleration(const NamedAngularVelocity& w_ab_c,
                                                              const NamedDisplacement& r_pq_c) {
  using namespace detail::letters;
  return typed_law<Law<AngularVelocity<A, B, In<C>>, Displacement<P, Q, In<C>>>>(
      "centrifugal_acceleration", [](const auto&... x) { return centrifugal_acceleration(x...); }, w_ab_c,
      r_pq_c);
}

inline std::ostream& print_framed(std::ostream& out, const NamedPointMotion& motion) {
  return out << motion.position << "; " << motion.velocity;
}

}  // namespace vectrix
