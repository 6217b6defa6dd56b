#pragma once

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// alpha_ab^c, `alpha_ab_c`: the angular acceleration of b relative to a, the derivative of w_ab observed
/// from a (or from b, which gives the same), expressed in c, rad/s^2. Its laws:
///     1.  alpha_ad = alpha_ab + alpha_bd + w_ab x w_bd    chain(alpha_ab_c, alpha_bd_c, w_ab_c, w_bd_c)
///     2.  alpha_ba^c = -alpha_ab^c
///     3.  alpha_ab^d = R_c^d alpha_ab^c
/// A sum or difference without the rates does not compile, whatever its frames: it lacks the transport term.
template <Frame A, Frame B, class Expressed, class S = double> class AngularAcceleration;

template <Frame A, Frame B, Frame C, class S>
class AngularAcceleration<A, B, In<C>, S> : public detail::RelativeVector<C, si::angular_acceleration, S> {
 public:
  template <class D> using Expressed = AngularAcceleration<A, B, In<D>, S>;

  AngularAcceleration() = delete;  // angular_acceleration(of<B>, relative_to<A>, alpha_ab_c)
  using detail::RelativeVector<C, si::angular_acceleration, S>::RelativeVector;

  /// alpha_ba^c = -alpha_ab^c
  AngularAcceleration<B, A, In<C>, S> operator-() const {
    return AngularAcceleration<B, A, In<C>, S>{detail::trusted, -this->coordinates()};
  }
};

template <class A, class B, class C, class S>
inline constexpr bool detail::is_framed<AngularAcceleration<A, B, C, S>> = true;
template <class A, class B, class C, class S>
struct QuestionOf<AngularAcceleration<A, B, In<C>, S>> : std::type_identity<AskAngularAcceleration<B, A, C>> {
};

template <class A, class B, class C, class S, class D, class E>
struct detail::ReasonOf<AngularAcceleration<A, B, C, S>, AngularAcceleration<D, E, C, S>>
    : std::conditional<std::is_same_v<A, D> && std::is_same_v<B, E>, reason::one_pair_twice,
                       reason::transport_term_is_lost> {};

/// Claims that the vector is the angular acceleration of b relative to a.
template <Frame B, Frame A, class C, class S>
detail::OfTwo<B, A, AngularAcceleration<A, B, In<C>, S>> angular_acceleration(
    Of<B>, RelativeTo<A>, const Vector<C, si::angular_acceleration, S>& alpha_ab_c) {
  return AngularAcceleration<A, B, In<C>, S>{detail::trusted, alpha_ab_c};
}
template <class OfFrame, class RelativeToFrame, class Given>
auto angular_acceleration(  // of<B>, relative_to<A>: two frames; a vector in rad/s^2
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

/// Claims that the rate of b relative to a does not change.
template <Frame B, Frame A, Frame C, class S = double>
detail::OfTwo<B, A, AngularAcceleration<A, B, In<C>, S>> unaccelerated(Of<B>, RelativeTo<A>, In<C>) {
  return AngularAcceleration<A, B, In<C>, S>{detail::trusted, zero<si::angular_acceleration, C, S>(in<C>)};
}
template <class OfFrame, class RelativeToFrame, class InFrame>
auto unaccelerated(  // of<B>, relative_to<A>, in<C>: b and a are two frames
    const OfFrame&, const RelativeToFrame&, const InFrame&) -> Refused = delete;

// alpha_ad^c = alpha_ab^c + alpha_bd^c + w_ab^c x w_bd^c
template <class A, class B, class D, class C, class S>
AngularAcceleration<A, D, In<C>, S> chained(const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c,
                                            const AngularAcceleration<B, D, In<C>, S>& alpha_bd_c,
                                            const AngularVelocity<A, B, In<C>, S>& w_ab_c,
                                            const AngularVelocity<B, D, In<C>, S>& w_bd_c) {
  return AngularAcceleration<A, D, In<C>, S>{
      detail::trusted, alpha_ab_c.vector() + alpha_bd_c.vector() + cross(w_ab_c.vector(), w_bd_c.vector())};
}

namespace detail {

template <class... Given> using ChainOf = decltype(chained(std::declval<const Given&>()...));
template <class... Given>
concept Chains = requires {
  typename ChainOf<Given...>;
};

}  // namespace detail

/// alpha_ad^c = alpha_ab^c + alpha_bd^c + w_ab^c x w_bd^c
/// All four are expressed in c. The cross term comes from the rotation of b, relative to which d rotates. The
/// rates of two twists also chain: chain(Vdot_ab, Vdot_bd, V_ab, V_bd).
template <class ChangeAb, class ChangeBd, class RateAb, class RateBd>
detail::ChainOf<ChangeAb, ChangeBd, RateAb, RateBd> chain(const ChangeAb& change_ab,
                                                          const ChangeBd& change_bd, const RateAb& rate_ab,
                                                          const RateBd& rate_bd) {
  return chained(change_ab, change_bd, rate_ab, rate_bd);
}
template <class ChangeAb, class ChangeBd, class RateAb, class RateBd>
  requires(detail::any_framed<ChangeAb, ChangeBd, RateAb, RateBd> &&
           !detail::Chains<ChangeAb, ChangeBd, RateAb, RateBd>)
auto chain(  // chain(alpha_ab_c, alpha_bd_c, w_ab_c, w_bd_c), one frame c
    const ChangeAb&, const ChangeBd&, const RateAb&, const RateBd&) -> Refused = delete;

/// |alpha_ab|, rad/s^2.
template <class A, class B, class C, class S>
Quantity<si::angular_acceleration, S> norm(const AngularAcceleration<A, B, C, S>& alpha_ab_c) {
  return norm(alpha_ab_c.vector());
}

// alpha_ab^d = R_c^d alpha_ab^c, with a quaternion
template <class D, class C, class A, class B, class S>
AngularAcceleration<A, B, In<D>, S> product(const Quaternion<D, C, S>& q_d_from_c,
                                            const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  return AngularAcceleration<A, B, In<D>, S>{detail::trusted, q_d_from_c * alpha_ab_c.vector()};
}

template <class A, class B, class C, class S>
std::ostream& print_framed(std::ostream& out, const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  return detail::print_column(out, alpha_ab_c.coordinates(), "rad/s^2")
         << detail::print_of_relative_to<B, A> << " in " << frame_name<C>();
}

}  // namespace vectrix
