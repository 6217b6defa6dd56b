#pragma once

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/frames/relative_vector.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>

namespace vectrix {

/// w_ab^c, `w_ab_c`, of type AngularVelocity<A, B, In<C>>: the angular velocity of b relative to a, expressed
/// in c, rad/s. Its laws:
///     1.  w_ab^c + w_bd^c = w_ad^c          sums chain, all expressed in one frame
///     2.  w_ba^c = -w_ab^c                  reversal
///     3.  w_ab^d = R_c^d w_ab^c             re-expression: R_d_from_c * w_ab_c, q_d_from_c * w_ab_c
/// Made by angular_velocity(of<B>, relative_to<A>, ...); there is no default.
template <Frame A, Frame B, class Expressed, class S = double> class AngularVelocity;

template <Frame A, Frame B, Frame C, class S>
class AngularVelocity<A, B, In<C>, S> : public detail::RelativeVector<C, si::angular_velocity, S> {
 public:
  using first = A;
  using second = B;
  template <class A2, class B2> using Between = AngularVelocity<A2, B2, In<C>, S>;
  template <class D> using Expressed = AngularVelocity<A, B, In<D>, S>;

  AngularVelocity() = delete;  // angular_velocity(of<B>, relative_to<A>, w_ab_c), or at_rest(...)
  using detail::RelativeVector<C, si::angular_velocity, S>::RelativeVector;

  /// w_ba^c = -w_ab^c
  Between<B, A> operator-() const { return Between<B, A>{detail::trusted, -this->coordinates()}; }
};

template <class A, class B, class C, class S>
inline constexpr bool detail::is_framed<AngularVelocity<A, B, C, S>> = true;
template <class A, class B, class C, class S>
struct QuestionOf<AngularVelocity<A, B, In<C>, S>> : std::type_identity<AskAngularVelocity<B, A, C>> {};

namespace detail {

/// A gain from rad/s to a torque or an angular momentum.
template <class V>
concept GainOfRate =
    one_of<unit_of_vector_product<V, si::angular_velocity>, si::torque, si::angular_momentum>;

}  // namespace detail

/// Claims that the vector is the angular velocity of b relative to a.
template <Frame B, Frame A, class C, class S>
detail::OfTwo<B, A, AngularVelocity<A, B, In<C>, S>> angular_velocity(
    Of<B>, RelativeTo<A>, const Vector<C, si::angular_velocity, S>& w_ab_c) {
  return AngularVelocity<A, B, In<C>, S>{detail::trusted, w_ab_c};
}
template <class OfFrame, class RelativeToFrame, class Given>
auto angular_velocity(  // of<B>, relative_to<A>: two frames; a vector in rad/s
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

/// Claims that b is at rest relative to a.
template <Frame B, Frame A, Frame C, class S = double>
detail::OfTwo<B, A, AngularVelocity<A, B, In<C>, S>> at_rest(Of<B>, RelativeTo<A>, In<C>) {
  return AngularVelocity<A, B, In<C>, S>{detail::trusted, zero<si::angular_velocity, C, S>(in<C>)};
}
template <class OfFrame, class RelativeToFrame, class InFrame>
auto at_rest(  // of<B>, relative_to<A>, in<C>: b and a are two frames
    const OfFrame&, const RelativeToFrame&, const InFrame&) -> Refused = delete;

// w_ab^c x r^c: a velocity if r is a position, a torque if r is an angular momentum.
template <class A, class B, class C, class U, class S>
Vector<C, unit_of_vector_product<si::angular_velocity, U>, S> cross_product(
    const AngularVelocity<A, B, In<C>, S>& w_ab_c, const Vector<C, U, S>& r_c) {
  return cross(w_ab_c.vector(), r_c);
}
// w_ab^c . r^c: an energy if r is an angular momentum, a power if r is a torque.
template <class A, class B, class C, class U, class S>
Quantity<unit_product<si::angular_velocity, U>, S> dot_product(const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                                               const Vector<C, U, S>& r_c) {
  return dot(w_ab_c.vector(), r_c);
}
template <class A, class B, class C, class U, class S>
Quantity<unit_product<U, si::angular_velocity>, S> dot_product(
    const Vector<C, U, S>& r_c, const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return dot(r_c, w_ab_c.vector());
}

// k w_ab^c with a gain k in N m s/rad, as of a damper: a torque. With a moment of inertia: an angular
// momentum.
template <detail::GainOfRate V, class A, class B, class C, class S>
Vector<C, unit_of_vector_product<V, si::angular_velocity>, S> product(
    const Quantity<V, S>& k, const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return {detail::trusted, k.value() * w_ab_c.coordinates()};
}

/// |w_ab|, rad/s.
template <class A, class B, class C, class S>
Quantity<si::angular_velocity, S> norm(const AngularVelocity<A, B, C, S>& w_ab_c) {
  return norm(w_ab_c.vector());
}

// w_ab^d = R_c^d w_ab^c, with a quaternion
template <class D, class C, class A, class B, class S>
AngularVelocity<A, B, In<D>, S> product(const Quaternion<D, C, S>& q_d_from_c,
                                        const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return AngularVelocity<A, B, In<D>, S>{detail::trusted, q_d_from_c * w_ab_c.vector()};
}

template <class A, class B, class C, class S>
std::ostream& print_framed(std::ostream& out, const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return detail::print_column(out, w_ab_c.coordinates(), "rad/s")
         << detail::print_of_relative_to<B, A> << " in " << frame_name<C>();
}

}  // namespace vectrix
