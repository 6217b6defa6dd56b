#pragma once

#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/screws/twist.hpp>

namespace vectrix {

/// Vdot_ab(p)^c, of type TwistRate<A, B, At<P>, In<C>>: the time derivative of the twist V_ab at a point and
/// in axes fixed in a (or fixed in b, which gives the same because ad(V) V = 0). It consists of alpha_ab^c
/// and of the rate of change of the velocity at the point p, through which the particles of b pass. Its laws:
///     1.  Vdot_ad = Vdot_ab + Vdot_bd + ad(V_ab) V_bd     chain(Vdot_ab, Vdot_bd, V_ab, V_bd)
///     2.  Vdot_ba(p)^c = -Vdot_ab(p)^c
///     3.  Vdot_ab(p)^d = R_c^d Vdot_ab(p)^c
///     4.  vdot(q) = vdot(p) + alpha_ab x r_pq             shift(Vdot_c, r_pq_c)
///     5.  Vdot_ab(c)^c = Ad(X_b^c) Vdot_ab(b)^b           X_c_from_b * Vdot
///     6.  a = vdot(p) + w_ab x v(p)                       of the particle of b at p: particle_acceleration()
template <Frame A, Frame B, class Place, class ExpressedIn, class S = double> class TwistRate;

template <Frame A, Frame B, Point P, Frame C, class S> class TwistRate<A, B, At<P>, In<C>, S> {
 public:
  TwistRate(detail::Trusted, const detail::Column<S>& alpha, const detail::Column<S>& change)
      : alpha_(detail::trusted, alpha), change_(detail::trusted, change) {}

  AngularAcceleration<A, B, In<C>, S> angular_acceleration() const {
    return AngularAcceleration<A, B, In<C>, S>{detail::trusted, alpha_};
  }
  /// vdot(p): the rate of the velocity at p, not the acceleration of a particle.
  const Vector<C, si::acceleration, S>& velocity_rate() const& { return change_; }
  Vector<C, si::acceleration, S> velocity_rate() && { return change_; }
  /// The six bare numbers, the angular acceleration first.
  Eigen::Matrix<S, 6, 1> coordinates() const {
    Eigen::Matrix<S, 6, 1> numbers;
    numbers << alpha_.coordinates(), change_.coordinates();
    return numbers;
  }
  /// Vdot_ba(p)^c = -Vdot_ab(p)^c
  TwistRate<B, A, At<P>, In<C>, S> operator-() const {
    return {detail::trusted, -alpha_.coordinates(), -change_.coordinates()};
  }

 private:
  Vector<C, si::angular_acceleration, S> alpha_;
  Vector<C, si::acceleration, S> change_;
};

template <class A, class B, class P, class C, class S>
inline constexpr bool detail::is_framed<TwistRate<A, B, P, C, S>> = true;

/// Claims that a_c is the acceleration, observed from a, of the particle of b at p: vdot(p) = a - w_ab x
/// v(p).
template <class A, class B, class P, class C, class S>
TwistRate<A, B, At<P>, In<C>, S> twist_rate(const Twist<A, B, At<P>, In<C>, S>& V_ab,
                                            const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c,
                                            const Vector<C, si::acceleration, S>& a_c) {
  return {detail::trusted, alpha_ab_c.coordinates(),
          a_c.coordinates() - V_ab.angular_velocity().coordinates().cross(V_ab.velocity().coordinates())};
}
template <class Motion, class Change, class AccelerationOf>
  requires detail::any_framed<Motion, Change, AccelerationOf>
auto twist_rate(  // twist_rate(V_ab, alpha_ab_c, a_c): of one pair, expressed in one frame
    const Motion&, const Change&, const AccelerationOf&) -> Refused = delete;

/// a, the acceleration of the particle of b at p, observed from a. At a's origin it is the linear part of
/// dV^/dt + V^ V^, where V^ is the 4x4 matrix of V: rddot_ab - ([alpha]x + [w]x [w]x) r_ab.
template <class A, class B, class P, class C, class S>
Vector<C, si::acceleration, S> particle_acceleration(const Twist<A, B, At<P>, In<C>, S>& V_ab,
                                                     const TwistRate<A, B, At<P>, In<C>, S>& Vdot_ab) {
  return {detail::trusted, Vdot_ab.velocity_rate().coordinates() +
                               V_ab.angular_velocity().coordinates().cross(V_ab.velocity().coordinates())};
}
template <class Motion, class Change>
  requires detail::FramedPair<Motion, Change>
auto particle_acceleration(  // particle_acceleration(V_ab, Vdot_ab): at one point, expressed in one frame
    const Motion&, const Change&) -> Refused = delete;

/// The velocity of q relative to a's origin, observed from a. Claims that q is fixed in b.
template <class Q, class A, class B, class C, class S>
Velocity<A, Q, ObservedFrom<A>, In<C>, S> point_velocity(Of<Q>, const Twist<A, B, At<Q>, In<C>, S>& V_ab) {
  return Velocity<A, Q, ObservedFrom<A>, In<C>, S>{detail::trusted, V_ab.velocity()};
}
/// The acceleration of q relative to a's origin, observed from a. Claims that q is fixed in b.
template <class Q, class A, class B, class C, class S>
Acceleration<A, Q, ObservedFrom<A>, In<C>, S> point_acceleration(
    Of<Q>, const Twist<A, B, At<Q>, In<C>, S>& V_ab, const TwistRate<A, B, At<Q>, In<C>, S>& Vdot_ab) {
  return Acceleration<A, Q, ObservedFrom<A>, In<C>, S>{detail::trusted, particle_acceleration(V_ab, Vdot_ab)};
}
template <class OfPoint, class Motion>
auto point_velocity(  // point_velocity(of<Q>, V_ab): the twist at q
    Of<OfPoint>, const Motion&) -> Refused = delete;
template <class OfPoint, class Motion, class Change>
auto point_acceleration(  // point_acceleration(of<Q>, V_ab, Vdot_ab): both at q, expressed in one frame
    Of<OfPoint>, const Motion&, const Change&) -> Refused = delete;

// Vdot_ad = Vdot_ab + Vdot_bd + ad(V_ab) V_bd
template <class A, class B, class D, class P, class C, class S>
TwistRate<A, D, At<P>, In<C>, S> chained(const TwistRate<A, B, At<P>, In<C>, S>& Vdot_ab,
                                         const TwistRate<B, D, At<P>, In<C>, S>& Vdot_bd,
                                         const Twist<A, B, At<P>, In<C>, S>& V_ab,
                                         const Twist<B, D, At<P>, In<C>, S>& V_bd) {
  const detail::Column<S> w_ab = V_ab.angular_velocity().coordinates();
  const detail::Column<S> w_bd = V_bd.angular_velocity().coordinates();
  return {detail::trusted,
          Vdot_ab.angular_acceleration().coordinates() + Vdot_bd.angular_acceleration().coordinates() +
              w_ab.cross(w_bd),
          Vdot_ab.velocity_rate().coordinates() + Vdot_bd.velocity_rate().coordinates() +
              w_ab.cross(V_bd.velocity().coordinates()) + V_ab.velocity().coordinates().cross(w_bd)};
}
// Vdot_ab(p)^d = R_c^d Vdot_ab(p)^c
template <class D, class C, class A, class B, class P, class S>
TwistRate<A, B, At<P>, In<D>, S> product(const Dcm<D, C, S>& R_d_from_c,
                                         const TwistRate<A, B, At<P>, In<C>, S>& Vdot_ab) {
  return {detail::trusted, R_d_from_c.matrix() * Vdot_ab.angular_acceleration().coordinates(),
          R_d_from_c.matrix() * Vdot_ab.velocity_rate().coordinates()};
}
// Vdot(c)^c = Ad(X_d^c) Vdot(d)^d
template <class C, class D, class A, class B, class S>
TwistRate<A, B, At<C>, In<C>, S> product(const Transform<C, D, S>& X_c_from_d,
                                         const TwistRate<A, B, At<D>, In<D>, S>& Vdot_ab) {
  const detail::Column<S> alpha_c =
      X_c_from_d.rotation.matrix() * Vdot_ab.angular_acceleration().coordinates();
  return {detail::trusted, alpha_c,
          X_c_from_d.rotation.matrix() * Vdot_ab.velocity_rate().coordinates() +
              X_c_from_d.translation.coordinates().cross(alpha_c)};
}
// vdot(q) = vdot(p) + alpha_ab x r_pq
template <class A, class B, class P, class Q, class C, class S>
TwistRate<A, B, At<Q>, In<C>, S> shifted(const TwistRate<A, B, At<P>, In<C>, S>& Vdot_ab,
                                         const Displacement<P, Q, In<C>, S>& r_pq_c) {
  const detail::Column<S> alpha = Vdot_ab.angular_acceleration().coordinates();
  return {detail::trusted, alpha, Vdot_ab.velocity_rate().coordinates() + alpha.cross(r_pq_c.coordinates())};
}

/// The twist V_ab(b)^b of a motion, and its derivative.
template <class A, class B, class S>
Twist<A, B, At<B>, In<B>, S> twist_of(const MovingTransform<A, B, S>& X_a_from_b) {
  return {detail::trusted, X_a_from_b.turning.angular_velocity.coordinates(),
          X_a_from_b.turning.rotation.matrix().transpose() * X_a_from_b.velocity.coordinates()};
}
template <class A, class B, class S>
Twist<A, B, At<B>, In<B>, S> twist_of(const AcceleratingTransform<A, B, S>& X_a_from_b) {
  return twist_of(moving_transform_of(X_a_from_b));
}
template <class A, class B, class S>
TwistRate<A, B, At<B>, In<B>, S> twist_rate_of(const AcceleratingTransform<A, B, S>& X_a_from_b) {
  const auto R_b_from_a = inverse(rotation_of(X_a_from_b));
  return twist_rate(twist_of(X_a_from_b), X_a_from_b.turning.angular_acceleration,
                    R_b_from_a * X_a_from_b.acceleration.vector());
}

template <class A, class B, class P, class C, class S>
std::ostream& print_framed(std::ostream& out, const TwistRate<A, B, At<P>, In<C>, S>& Vdot_ab) {
  return out << Vdot_ab.angular_acceleration() << "; " << Vdot_ab.velocity_rate() << " at "
             << frame_name<P>();
}

}  // namespace vectrix
