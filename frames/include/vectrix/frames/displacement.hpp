#pragma once

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/frames/relative_vector.hpp>

namespace vectrix {

/// r_pq^c, `r_pq_c`, of type Displacement<P, Q, In<C>>: the position of the point q relative to the point p,
/// expressed in c, m. A frame given as a point stands for its origin. Its laws:
///     1.  r_pq^c + r_qs^c = r_ps^c
///     2.  r_qp^c = -r_pq^c
///     3.  r_pq^d = R_c^d r_pq^c
/// Made by displacement(of<Q>, relative_to<P>, ...); there is no default.
template <Point P, Point Q, class ExpressedIn, class S = double> class Displacement;

template <Point P, Point Q, Frame C, class S>
class Displacement<P, Q, In<C>, S> : public detail::RelativeVector<C, si::length, S> {
 public:
  using first = P;
  using second = Q;
  template <class P2, class Q2> using Between = Displacement<P2, Q2, In<C>, S>;
  template <class D> using Expressed = Displacement<P, Q, In<D>, S>;

  using detail::RelativeVector<C, si::length, S>::RelativeVector;

  /// r_qp^c = -r_pq^c
  Between<Q, P> operator-() const { return Between<Q, P>{detail::trusted, -this->coordinates()}; }
};

template <class P, class Q, class C, class S>
inline constexpr bool detail::is_framed<Displacement<P, Q, C, S>> = true;
template <class P, class Q, class C, class S>
struct QuestionOf<Displacement<P, Q, In<C>, S>> : std::type_identity<AskPosition<Q, P, C>> {};

/// Claims that the vector is the position of q relative to p.
template <Point Q, Point P, class C, class S>
detail::OfTwo<P, Q, Displacement<P, Q, In<C>, S>> displacement(Of<Q>, RelativeTo<P>,
                                                               const Vector<C, si::length, S>& r_pq_c) {
  return Displacement<P, Q, In<C>, S>{detail::trusted, r_pq_c};
}
template <class Q, class P, class Given>
auto displacement(  // of<Q>, relative_to<P>: two points; in metres
    Of<Q>, RelativeTo<P>, const Given&) -> Refused = delete;

/// Claims that q is at p.
template <Point Q, Point P, Frame C, class S = double>
Displacement<P, Q, In<C>, S> coincident(Of<Q>, RelativeTo<P>, In<C>) {
  return Displacement<P, Q, In<C>, S>{detail::trusted, detail::Column<S>::Zero()};
}

/// |r_pq|, m.
template <class P, class Q, class C, class S>
Quantity<si::length, S> norm(const Displacement<P, Q, C, S>& r_pq_c) {
  return norm(r_pq_c.vector());
}

template <class P, class Q, class C, class S>
std::ostream& print_framed(std::ostream& out, const Displacement<P, Q, In<C>, S>& r_pq_c) {
  return detail::print_column(out, r_pq_c.coordinates(), "m")
         << detail::print_of_relative_to<Q, P> << " in " << frame_name<C>();
}

}  // namespace vectrix
