#pragma once

#include <vectrix/kinematics/named/attitude.hpp>
#include <vectrix/kinematics/named/motions.hpp>
#include <vectrix/kinematics/screws/constant_twist.hpp>
#include <vectrix/kinematics/screws/screw_axis.hpp>
#include <vectrix/kinematics/screws/screw_rate.hpp>
#include <vectrix/kinematics/screws/twist_rate.hpp>

namespace vectrix {

// Twists and screws between frames known at run time: the words of kinematics/screws/, with the same laws and
// errors. The point of a twist is the origin of a frame, At(camera).

template <detail::RunTimeFrame F> struct At<F> : detail::Word<F> { using detail::Word<F>::Word; };
At(NamedFrame)->At<NamedFrame>;

namespace detail {

inline std::string described(At<NamedFrame> p) {
  return "at " + in_quotes(p.frame);
}

/// The forms V_ab(p)^c and Vdot_ab(p)^c of the laws.
template <class A, class B, class P, class C> using TwistAt = Twist<A, B, At<P>, In<C>>;
template <class A, class B, class P, class C> using TwistRateAt = TwistRate<A, B, At<P>, In<C>>;

template <class A, class B, class P, class C> struct Relabel<Twist<A, B, At<P>, In<C>>> {
  template <class X> static TwistAt<A, B, P, C> of(const X& V) {
    return {trusted, V.angular_velocity().coordinates(), V.velocity().coordinates()};
  }
};
template <class A, class B, class P, class C> struct Relabel<TwistRate<A, B, At<P>, In<C>>> {
  template <class X> static TwistRateAt<A, B, P, C> of(const X& Vdot) {
    return {trusted, Vdot.angular_acceleration().coordinates(), Vdot.velocity_rate().coordinates()};
  }
};
template <class A, class B> struct Relabel<Screw<A, B>> {
  template <class X> static Screw<A, B> of(const X& xi) {
    return {trusted, xi.rotation_vector().coordinates(), xi.in_reference().coordinates()};
  }
};
template <class A, class B> struct Relabel<ScrewRate<A, B>> {
  template <class X> static ScrewRate<A, B> of(const X& xidot) {
    return {trusted, xidot.rotation(), xidot.translation()};
  }
};
template <class A> struct Relabel<ScrewAxis<A>> {
  template <class X> static ScrewAxis<A> of(const X& axis) {
    return {relabelled<Vector<A, si::dimensionless>>(axis.direction),
            relabelled<Vector<A, si::length>>(axis.place), axis.angle, axis.advance};
  }
};

}  // namespace detail

/// V_ab(p)^c, its derivative, xi_ab and its derivative: Twist, TwistRate, Screw and ScrewRate for frames
/// known at run time.
using NamedTwist = Named<detail::TwistAt<Some<'a'>, Some<'b'>, Some<'c'>, Some<'d'>>>;
using NamedTwistRate = Named<detail::TwistRateAt<Some<'a'>, Some<'b'>, Some<'c'>, Some<'d'>>>;
using NamedScrew = Named<Screw<Some<'a'>, Some<'b'>>>;
using NamedScrewRate = Named<ScrewRate<Some<'a'>, Some<'b'>>>;
/// ScrewAxis for a frame known at run time.
struct NamedScrewAxis {
  NamedVector<si::dimensionless> direction;
  NamedVector<si::length> place;
  Quantity<si::angle> angle;
  Quantity<si::length> advance;
};
template <> struct detail::NamedFor<ScrewAxis<Some<'a'>>> : std::type_identity<NamedScrewAxis> {};
template <> struct detail::Naming<NamedScrewAxis> {
  using form = ScrewAxis<Some<'a'>>;
  static std::array<NamedFrame, 1> frames(const NamedScrewAxis& axis) { return {axis.direction.in()}; }
  template <class Typed> static NamedScrewAxis make(const std::array<NamedFrame, 1>& f, const Typed& axis) {
    return {Naming<NamedVector<si::dimensionless>>::make(f, axis.direction),
            Naming<NamedVector<si::length>>::make(f, axis.place), axis.angle, axis.advance};
  }
};

/// Claims that v_c is the velocity, observed from a, of the particle of b at p.
inline NamedTwist twist(At<NamedFrame> p, const NamedAngularVelocity& w_ab_c,
                        const NamedVector<si::velocity>& v_c) {
  using namespace detail::letters;
  return typed_law<Law<At<P>, AngularVelocity<A, B, In<C>>, Vector<C, si::velocity>>>(
      "twist", [](const auto&... x) { return twist(x...); }, p, w_ab_c, v_c);
}
/// Claims that a_c is the acceleration, observed from a, of the particle of b at p.
inline NamedTwistRate twist_rate(const NamedTwist& V_ab, const NamedAngularAcceleration& alpha_ab_c,
                                 const NamedVector<si::acceleration>& a_c) {
  using namespace detail::letters;
  return typed_law<
      Law<detail::TwistAt<A, B, P, C>, AngularAcceleration<A, B, In<C>>, Vector<C, si::acceleration>>>(
      "twist_rate", [](const auto&... x) { return twist_rate(x...); }, V_ab, alpha_ab_c, a_c);
}
inline NamedTwist twist_of(const NamedMovingTransform& X_a_from_b) {
  return detail::of_one(
      "twist_of", [](const auto& X) { return twist_of(X); }, X_a_from_b);
}
inline NamedTwist twist_of(const NamedAcceleratingTransform& X_a_from_b) {
  return detail::of_one(
      "twist_of", [](const auto& X) { return twist_of(X); }, X_a_from_b);
}
inline NamedTwistRate twist_rate_of(const NamedAcceleratingTransform& X_a_from_b) {
  return detail::of_one(
      "twist_rate_of", [](const auto& X) { return twist_rate_of(X); }, X_a_from_b);
}

// V_ad = V_ab + V_bd; V_bd = V_ad - V_ab, V_ab = V_ad - V_bd, at one point
inline NamedTwist sum(const NamedTwist& V_ab, const NamedTwist& V_bd) {
  using namespace detail::letters;
  return typed_law<Law<detail::TwistAt<A, B, P, C>, detail::TwistAt<B, D, P, C>>>(
      "sum", [](const auto& V, const auto& W) { return V + W; }, V_ab, V_bd);
}
inline NamedTwist difference(const NamedTwist& left, const NamedTwist& right) {
  using namespace detail::letters;
  if (left.frames()[0] == right.frames()[0] && left.frames()[1] == right.frames()[1])
    throw BadInput(detail::action_text("difference", left, right) + ": one pair twice");
  return typed_law<Law<detail::TwistAt<A, D, P, C>, detail::TwistAt<A, B, P, C>>,
                   Law<detail::TwistAt<A, D, P, C>, detail::TwistAt<B, D, P, C>>>(
      "difference", [](const auto& V, const auto& W) { return V - W; }, left, right);
}
// chain(Vdot_ab, Vdot_bd, V_ab, V_bd)
inline NamedTwistRate chained(const NamedTwistRate& Vdot_ab, const NamedTwistRate& Vdot_bd,
                              const NamedTwist& V_ab, const NamedTwist& V_bd) {
  using namespace detail::letters;
  return typed_law<Law<detail::TwistRateAt<A, B, P, C>, detail::TwistRateAt<B, D, P, C>,
                       detail::TwistAt<A, B, P, C>, detail::TwistAt<B, D, P, C>>>(
      "chain", [](const auto&... x) { return chain(x...); }, Vdot_ab, Vdot_bd, V_ab, V_bd);
}

// In other axes, R_d_from_c * V, and at another origin in its axes, X_c_from_d * V
inline NamedTwist product(const NamedDcm& R_d_from_c, const NamedTwist& V_ab) {
  using namespace detail::letters;
  return typed_law<Law<Dcm<D, C>, detail::TwistAt<A, B, P, C>>>(
      "product", [](const auto& R, const auto& V) { return R * V; }, R_d_from_c, V_ab);
}
inline NamedTwist product(const NamedTransform& X_c_from_d, const NamedTwist& V_ab) {
  using namespace detail::letters;
  return typed_law<Law<Transform<C, D>, detail::TwistAt<A, B, D, D>>>(
      "product", [](const auto& X, const auto& V) { return X * V; }, X_c_from_d, V_ab);
}
inline NamedTwistRate product(const NamedDcm& R_d_from_c, const NamedTwistRate& Vdot_ab) {
  using namespace detail::letters;
  return typed_law<Law<Dcm<D, C>, detail::TwistRateAt<A, B, P, C>>>(
      "product", [](const auto& R, const auto& Vdot) { return R * Vdot; }, R_d_from_c, Vdot_ab);
}
inline NamedTwistRate product(const NamedTransform& X_c_from_d, const NamedTwistRate& Vdot_ab) {
  using namespace detail::letters;
  return typed_law<Law<Transform<C, D>, detail::TwistRateAt<A, B, D, D>>>(
      "product", [](const auto& X, const auto& Vdot) { return X * Vdot; }, X_c_from_d, Vdot_ab);
}
// shift(V_c, r_pq_c) to another point
inline NamedTwist shifted(const NamedTwist& V_ab, const NamedDisplacement& r_pq_c) {
  using namespace detail::letters;
  return typed_law<Law<detail::TwistAt<A, B, P, C>, Displacement<P, Q, In<C>>>>(
      "shift", [](const auto&... x) { return shift(x...); }, V_ab, r_pq_c);
}
inline NamedTwistRate shifted(const NamedTwistRate& Vdot_ab, const NamedDisplacement& r_pq_c) {
  using namespace detail::letters;
  return typed_law<Law<detail::TwistRateAt<A, B, P, C>, Displacement<P, Q, In<C>>>>(
      "shift", [](const auto&... x) { return shift(x...); }, Vdot_ab, r_pq_c);
}

/// The acceleration, observed from a, of the particle of b at the point of the twist.
inline NamedVector<si::acceleration> particle_acceleration(const NamedTwist& V_ab,
                                                           const NamedTwistRate& Vdot_ab) {
  using namespace detail::letters;
  return typed_law<Law<detail::TwistAt<A, B, P, C>, detail::TwistRateAt<A, B, P, C>>>(
      "particle_acceleration", [](const auto&... x) { return particle_acceleration(x...); }, V_ab, Vdot_ab);
}
/// Velocity and acceleration of q relative to a's origin, observed from a. Claim that q is fixed in b.
inline NamedVelocity point_velocity(Of<NamedFrame> q, const NamedTwist& V_ab) {
  using namespace detail::letters;
  return typed_law<Law<Of<Q>, detail::TwistAt<A, B, Q, C>>>(
      "point_velocity", [](const auto&... x) { return point_velocity(x...); }, q, V_ab);
}
inline NamedAcceleration point_acceleration(Of<NamedFrame> q, const NamedTwist& V_ab,
                                            const NamedTwistRate& Vdot_ab) {
  using namespace detail::letters;
  return typed_law<Law<Of<Q>, detail::TwistAt<A, B, Q, C>, detail::TwistRateAt<A, B, Q, C>>>(
      "point_acceleration", [](const auto&... x) { return point_acceleration(x...); }, q, V_ab, Vdot_ab);
}

/// ad of a twist or a screw, Ad of a transform, as bare 6x6 matrices.
template <class Form> auto ad(const Named<Form>& V_ab) {
  return detail::of_one(
      "ad", [](const auto& V) { return ad(V); }, V_ab);
}
inline auto adjoint(const NamedTransform& X_b_from_a) {
  return detail::of_one(
      "adjoint", [](const auto& X) { return adjoint(X); }, X_b_from_a);
}

/// Claims that theta and rho are xi_ab, both expressed in a or both in b; of their derivatives likewise.
inline NamedScrew screw(Of<NamedFrame> b, RelativeTo<NamedFrame> a, const NamedVector<si::angle>& theta,
                        const NamedVector<si::length>& rho) {
  using namespace detail::letters;
  return typed_law<Law<Of<B>, RelativeTo<A>, Vector<B, si::angle>, Vector<B, si::length>>,
                   Law<Of<B>, RelativeTo<A>, Vector<A, si::angle>, Vector<A, si::length>>>(
      "screw", [](const auto&... x) { return screw(x...); }, b, a, theta, rho);
}
inline NamedScrewRate screw_rate(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                 const NamedVector<si::angular_velocity>& theta_dot,
                                 const NamedVector<si::velocity>& rho_dot) {
  using namespace detail::letters;
  return typed_law<Law<Of<B>, RelativeTo<A>, Vector<B, si::angular_velocity>, Vector<B, si::velocity>>,
                   Law<Of<B>, RelativeTo<A>, Vector<A, si::angular_velocity>, Vector<A, si::velocity>>>(
      "screw_rate", [](const auto&... x) { return screw_rate(x...); }, b, a, theta_dot, rho_dot);
}
inline NamedScrew screw_along(Of<NamedFrame> b, RelativeTo<NamedFrame> a, const NamedScrewAxis& axis) {
  using namespace detail::letters;
  return typed_law<Law<Of<B>, RelativeTo<A>, ScrewAxis<A>>>(
      "screw_along", [](const auto&... x) { return screw_along(x...); }, b, a, axis);
}
inline NamedScrewAxis screw_axis(const NamedScrew& xi_ab) {
  return detail::of_one(
      "screw_axis", [](const auto& xi) { return screw_axis(xi); }, xi_ab);
}
inline NamedTransform exp(const NamedScrew& xi_ab) {
  return detail::of_one(
      "exp", [](const auto& xi) { return exp(xi); }, xi_ab);
}
inline NamedScrew log(const NamedTransform& X_a_from_b) {
  return detail::of_one(
      "log", [](const auto& X) { return log(X); }, X_a_from_b);
}

// twist_from(xi_ab, xidot_ab, In(c)) and rate(xi_ab, V_ab), with c = b or a
inline NamedTwist twist_from(const NamedScrew& xi_ab, const NamedScrewRate& xidot_ab, In<NamedFrame> c) {
  using namespace detail::letters;
  return typed_law<Law<Screw<A, B>, ScrewRate<A, B>, In<B>>, Law<Screw<A, B>, ScrewRate<A, B>, In<A>>>(
      "twist_from", [](const auto&... x) { return twist_from(x...); }, xi_ab, xidot_ab, c);
}
inline NamedScrewRate attitude_rate(const NamedScrew& xi_ab, const NamedTwist& V_ab) {
  using namespace detail::letters;
  return typed_law<Law<Screw<A, B>, detail::TwistAt<A, B, B, B>>,
                   Law<Screw<A, B>, detail::TwistAt<A, B, A, A>>>(
      "rate", [](const auto&... x) { return rate(x...); }, xi_ab, V_ab);
}
// held(V_ab, t) and moved(X_a_from_b, V_ab, t): V_ab at b in b, or at a in a
inline NamedScrew held(const NamedTwist& V_ab, const Quantity<si::time>& t) {
  using namespace detail::letters;
  return typed_law<Law<detail::TwistAt<A, B, B, B>>, Law<detail::TwistAt<A, B, A, A>>>(
      "held", [&](const auto& V) { return held(V, t); }, V_ab);
}
inline NamedTransform moved(const NamedTransform& X_a_from_b, const NamedTwist& V_ab,
                            const Quantity<si::time>& t) {
  using namespace detail::letters;
  return typed_law<Law<Transform<A, B>, detail::TwistAt<A, B, B, B>>,
                   Law<Transform<A, B>, detail::TwistAt<A, B, A, A>>>(
      "moved", [&](const auto&... x) { return moved(x..., t); }, X_a_from_b, V_ab);
}

inline std::ostream& print_framed(std::ostream& out, const NamedScrewAxis& axis) {
  return out << axis.direction << " at " << axis.place << ", turn " << axis.angle << ", advance "
             << axis.advance;
}

}  // namespace vectrix
