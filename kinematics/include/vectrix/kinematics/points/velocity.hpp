#pragma once

#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/graph/level.hpp>
#include <vectrix/kinematics/points/derivative.hpp>

namespace vectrix {

/// v_pq|a^c, `v_pq_a_c`, of type Velocity<P, Q, ObservedFrom<A>, In<C>>: the velocity of the point q relative
/// to the point p, d/dt|_a r_pq for an observer fixed in a, expressed in c, m/s. Its laws:
///     1.  v_pq|a^c + v_qs|a^c = v_ps|a^c          sums chain for one observer
///     2.  v_qp|a^c = -v_pq|a^c
///     3.  v_pq|a^d = R_c^d v_pq|a^c
///     4.  v_pq|a = v_pq|b + w_ab x r_pq           transport() to another observer
template <Point P, Point Q, class Observer, class ExpressedIn, class S = double> class Velocity;

template <Point P, Point Q, Frame A, Frame C, class S>
class Velocity<P, Q, ObservedFrom<A>, In<C>, S> : public detail::RelativeVector<C, si::velocity, S> {
 public:
  using first = P;
  using second = Q;
  template <class P2, class Q2> using Between = Velocity<P2, Q2, ObservedFrom<A>, In<C>, S>;
  template <class D> using Expressed = Velocity<P, Q, ObservedFrom<A>, In<D>, S>;

  using detail::RelativeVector<C, si::velocity, S>::RelativeVector;
  template <class P2, class Q2, class Observer, class ExpressedIn, class S2>
  Velocity(  // the same points, observer and axes; transport() to another observer
      const Velocity<P2, Q2, Observer, ExpressedIn, S2>&) = delete;

  /// v_qp|a^c = -v_pq|a^c
  Between<Q, P> operator-() const { return Between<Q, P>{detail::trusted, -this->coordinates()}; }
};

template <class P, class Q, class A, class C, class S>
inline constexpr bool detail::is_framed<Velocity<P, Q, A, C, S>> = true;
template <class P, class Q, class A, class R, class T, class B, class C, class S>
  requires(!std::is_same_v<A, B>)
struct detail::ReasonOf<Velocity<P, Q, ObservedFrom<A>, In<C>, S>, Velocity<R, T, ObservedFrom<B>, In<C>, S>>
    : std::type_identity<reason::seen_by_two_observers> {};
template <class P, class Q, class A, class C, class S>
struct QuestionOf<Velocity<P, Q, ObservedFrom<A>, In<C>, S>> : std::type_identity<AskVelocity<Q, P, A, C>> {};

/// Claims that the vector is the velocity of q relative to p, observed from a.
template <Point Q, Point P, Frame A, class C, class S>
detail::OfTwo<P, Q, Velocity<P, Q, ObservedFrom<A>, In<C>, S>> velocity(
    Of<Q>, RelativeTo<P>, ObservedFrom<A>, const Vector<C, si::velocity, S>& v_pq_a_c) {
  return Velocity<P, Q, ObservedFrom<A>, In<C>, S>{detail::trusted, v_pq_a_c};
}
template <class Q, class P, class A, class Given>
auto velocity(  // of<Q>, relative_to<P>: two points; in m/s
    Of<Q>, RelativeTo<P>, ObservedFrom<A>, const Given&) -> Refused = delete;

/// Claims that q is at rest relative to p, observed from a.
template <Point Q, Point P, Frame A, Frame C, class S = double>
Velocity<P, Q, ObservedFrom<A>, In<C>, S> at_rest(Of<Q>, RelativeTo<P>, ObservedFrom<A>, In<C>) {
  return Velocity<P, Q, ObservedFrom<A>, In<C>, S>{detail::trusted, detail::Column<S>::Zero()};
}

/// v_pq|a = v_pq|b + w_ab x r_pq, all expressed in c.
template <class A, class B, class P, class Q, class C, class S>
Velocity<P, Q, ObservedFrom<A>, In<C>, S> transported(
    ObservedFrom<A>, const Velocity<P, Q, ObservedFrom<B>, In<C>, S>& v_pq_b_c,
    const Displacement<P, Q, In<C>, S>& r_pq_c, const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return Velocity<P, Q, ObservedFrom<A>, In<C>, S>{
      detail::trusted, v_pq_b_c.coordinates() + w_ab_c.coordinates().cross(r_pq_c.coordinates())};
}

/// |v|, m/s.
template <class P, class Q, class A, class C, class S>
Quantity<si::velocity, S> norm(const Velocity<P, Q, A, C, S>& v_pq_a_c) {
  return norm(v_pq_a_c.vector());
}

template <class P, class Q, class A, class C, class S>
std::ostream& print_framed(std::ostream& out, const Velocity<P, Q, ObservedFrom<A>, In<C>, S>& v_pq_a_c) {
  return detail::print_column(out, v_pq_a_c.coordinates(), "m/s")
         << detail::print_of_relative_to<Q, P> << " observed from " << frame_name<A>() << " in "
         << frame_name<C>();
}

}  // namespace vectrix
