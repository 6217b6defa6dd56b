#pragma once

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/kinematics/points/velocity.hpp>
#include <vectrix/kinematics/rates/angular_acceleration.hpp>

namespace vectrix {

/// a_pq|a^c, `a_pq_a_c`, of type Acceleration<P, Q, ObservedFrom<A>, In<C>>: the acceleration of the point q
/// relative to the point p, the second derivative of r_pq for an observer fixed in a, expressed in c, m/s^2.
/// Its laws:
///     1.  a_pq|a^c + a_qs|a^c = a_ps|a^c
///     2.  a_qp|a^c = -a_pq|a^c
///     3.  a_pq|a^d = R_c^d a_pq|a^c
///     4.  transport() to another observer
template <Point P, Point Q, class Observer, class ExpressedIn, class S = double> class Acceleration;

template <Point P, Point Q, Frame A, Frame C, class S>
class Acceleration<P, Q, ObservedFrom<A>, In<C>, S> : public detail::RelativeVector<C, si::acceleration, S> {
 public:
  using first = P;
  using second = Q;
  template <class P2, class Q2> using Between = Acceleration<P2, Q2, ObservedFrom<A>, In<C>, S>;
  template <class D> using Expressed = Acceleration<P, Q, ObservedFrom<A>, In<D>, S>;

  using detail::RelativeVector<C, si::acceleration, S>::RelativeVector;

  /// a_qp|a^c = -a_pq|a^c
  Between<Q, P> operator-() const { return Between<Q, P>{detail::trusted, -this->coordinates()}; }
};

template <class P, class Q, class A, class C, class S>
inline constexpr bool detail::is_framed<Acceleration<P, Q, A, C, S>> = true;
template <class P, class Q, class A, class R, class T, class B, class C, class S>
  requires(!std::is_same_v<A, B>)
struct detail::ReasonOf<Acceleration<P, Q, ObservedFrom<A>, In<C>, S>,
                        Acceleration<R, T, ObservedFrom<B>, In<C>, S>>
    : std::type_identity<reason::seen_by_two_observers> {};
template <class P, class Q, class A, class C, class S>
struct QuestionOf<Acceleration<P, Q, ObservedFrom<A>, In<C>, S>>
    : std::type_identity<AskAcceleration<Q, P, A, C>> {};

/// Claims that the vector is the acceleration of q relative to p, observed from a.
template <Point Q, Point P, Frame A, class C, class S>
detail::OfTwo<P, Q, Acceleration<P, Q, ObservedFrom<A>, In<C>, S>> acceleration(
    Of<Q>, RelativeTo<P>, ObservedFrom<A>, const Vector<C, si::acceleration, S>& a_pq_a_c) {
  return Acceleration<P, Q, ObservedFrom<A>, In<C>, S>{detail::trusted, a_pq_a_c};
}
template <class Q, class P, class A, class Given>
auto acceleration(  // of<Q>, relative_to<P>: two points; in m/s^2
    Of<Q>, RelativeTo<P>, ObservedFrom<A>, const Given&) -> Refused = delete;

/// Claims that q has no acceleration relative to p, observed from a.
template <Point Q, Point P, Frame A, Frame C, class S = double>
Acceleration<P, Q, ObservedFrom<A>, In<C>, S> unaccelerated(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) {
  return Acceleration<P, Q, ObservedFrom<A>, In<C>, S>{detail::trusted, detail::Column<S>::Zero()};
}

// The apparent accelerations for an observer in b, due to the rotation of b relative to a:
//     a_pq|b = a_pq|a + Euler + Coriolis + centrifugal

/// The Euler acceleration, -alpha_ab x r_pq.
template <class A, class B, class P, class Q, class C, class S>
Vector<C, si::acceleration, S> euler_acceleration(const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c,
                                                  const Displacement<P, Q, In<C>, S>& r_pq_c) {
  return {detail::trusted, r_pq_c.coordinates().cross(alpha_ab_c.coordinates())};
}
/// The Coriolis acceleration, -2 w_ab x v_pq|b, where v_pq|b is the velocity observed from b.
template <class A, class B, class P, class Q, class C, class S>
Vector<C, si::acceleration, S> coriolis_acceleration(
    const AngularVelocity<A, B, In<C>, S>& w_ab_c,
    const Velocity<P, Q, ObservedFrom<B>, In<C>, S>& v_pq_b_c) {
  return {detail::trusted, S(2) * v_pq_b_c.coordinates().cross(w_ab_c.coordinates())};
}
/// The centrifugal acceleration, -w_ab x (w_ab x r_pq).
template <class A, class B, class P, class Q, class C, class S>
Vector<C, si::acceleration, S> centrifugal_acceleration(const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                                        const Displacement<P, Q, In<C>, S>& r_pq_c) {
  const detail::Column<S> w = w_ab_c.coordinates();
  return {detail::trusted, w.cross(r_pq_c.coordinates().cross(w))};
}
template <class Motion, class Place>
  requires detail::FramedPair<Motion, Place>
auto euler_acceleration(  // euler_acceleration(alpha_ab_c, r_pq_c): expressed in one frame
    const Motion&, const Place&) -> Refused = delete;
template <class Rate, class VelocityOf>
  requires detail::FramedPair<Rate, VelocityOf>
auto coriolis_acceleration(  // coriolis_acceleration(w_ab_c, v_pq_b_c): v as b sees it, both in c
    const Rate&, const VelocityOf&) -> Refused = delete;
template <class Rate, class Place>
  requires detail::FramedPair<Rate, Place>
auto centrifugal_acceleration(  // centrifugal_acceleration(w_ab_c, r_pq_c): expressed in one frame
    const Rate&, const Place&) -> Refused = delete;

/// a_pq|a = a_pq|b + alpha_ab x r_pq + 2 w_ab x v_pq|b + w_ab x (w_ab x r_pq), all expressed in c.
template <class A, class B, class P, class Q, class C, class S>
Acceleration<P, Q, ObservedFrom<A>, In<C>, S> transported(
    ObservedFrom<A>, const Acceleration<P, Q, ObservedFrom<B>, In<C>, S>& a_pq_b_c,
    const Velocity<P, Q, ObservedFrom<B>, In<C>, S>& v_pq_b_c, const Displacement<P, Q, In<C>, S>& r_pq_c,
    const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c, const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  const detail::Column<S> r = r_pq_c.coordinates();
  const detail::Column<S> w = w_ab_c.coordinates();
  const detail::Column<S> turning = S(2) * v_pq_b_c.coordinates() + w.cross(r);
  return Acceleration<P, Q, ObservedFrom<A>, In<C>, S>{
      detail::trusted, a_pq_b_c.coordinates() + alpha_ab_c.coordinates().cross(r) + w.cross(turning)};
}

template <class P, class Q, class A, class C, class S>
std::ostream& print_framed(std::ostream& out, const Acceleration<P, Q, ObservedFrom<A>, In<C>, S>& a_pq_a_c) {
  return detail::print_column(out, a_pq_a_c.coordinates(), "m/s^2")
         << detail::print_of_relative_to<Q, P> << " observed from " << frame_name<A>() << " in "
         << frame_name<C>();
}

}  // namespace vectrix
