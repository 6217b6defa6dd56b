#pragma once

#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// d/dt|_a r, expressed in c: the derivative of the vector r for an observer fixed in a. U is the unit of r;
/// the unit of the derivative is U per second. d/dt|_a and d/dt|_b are different types; transport() converts
/// one to the other.
template <Frame A, Frame C, VectorUnit U, class S = double> class Derivative {
 public:
  using unit = unit_of_vector_quotient<U, si::time>;

  Derivative(detail::Trusted, const Vector<C, unit, S>& vector) : vector_(vector) {}

  const Vector<C, unit, S>& vector() const& { return vector_; }
  Vector<C, unit, S> vector() && { return vector_; }

 private:
  Vector<C, unit, S> vector_;
};

/// Claims that rdot_c is d/dt|_a of a vector in the unit U: derivative<si::length>(observed_from<A>, v_c).
template <VectorUnit U, Frame A, class C, class S>
Derivative<A, C, U, S> derivative(ObservedFrom<A>,
                                  const Vector<C, unit_of_vector_quotient<U, si::time>, S>& rdot_c) {
  return {detail::trusted, rdot_c};
}

template <class A, class C, class U, class S>
inline constexpr bool detail::is_framed<Derivative<A, C, U, S>> = true;
template <class A, class B, class C, class U, class S>
  requires(!std::is_same_v<A, B>)
struct detail::ReasonOf<Derivative<A, C, U, S>, Derivative<B, C, U, S>>
    : std::type_identity<reason::seen_by_two_observers> {};

// d/dt|_a r = d/dt|_b r + w_ab x r
template <class A, class B, class C, class U, class S>
Derivative<A, C, U, S> transported(ObservedFrom<A>, const Derivative<B, C, U, S>& rdot_c,
                                   const Vector<C, U, S>& r_c,
                                   const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return {detail::trusted, Vector<C, typename Derivative<A, C, U, S>::unit, S>{
                               detail::trusted, rdot_c.vector().coordinates() +
                                                    w_ab_c.coordinates().cross(r_c.coordinates())}};
}

namespace detail {

template <class ToObserver, class... Given>
using TransportOf = decltype(transported(std::declval<ToObserver>(), std::declval<const Given&>()...));
template <class ToObserver, class... Given>
concept Transports = requires {
  typename TransportOf<ToObserver, Given...>;
};

}  // namespace detail

/// Takes a derivative observed from b to the observer in a, all expressed in one frame c:
///     transport(observed_from<A>, rdot_c, r_c, w_ab_c)
/// for a Derivative, and likewise for a Velocity or an Acceleration.
template <class ToObserver, class Change, class... Operands>
detail::TransportOf<ToObserver, Change, Operands...> transport(ToObserver observer, const Change& change,
                                                               const Operands&... operands) {
  return transported(observer, change, operands...);
}
template <class ToObserver, class Change, class... Operands>
  requires(detail::any_framed<Change, Operands...> && !detail::Transports<ToObserver, Change, Operands...>)
auto transport(  // transport(observed_from<A>, rdot_c, r_c, w_ab_c), one frame c
    ToObserver, const Change&, const Operands&...) -> Refused = delete;

template <class A, class C, class U, class S>
std::ostream& print_framed(std::ostream& out, const Derivative<A, C, U, S>& rdot_c) {
  return out << rdot_c.vector() << " observed from " << frame_name<A>();
}

}  // namespace vectrix
