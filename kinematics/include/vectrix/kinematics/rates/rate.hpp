#pragma once

#include <vectrix/kinematics/rates/dcm_rate.hpp>
#include <vectrix/kinematics/rates/quaternion_rate.hpp>

namespace vectrix {
namespace detail {

template <class Rotation, class Rate>
using DerivativeOf = decltype(attitude_rate(std::declval<const Rotation&>(), std::declval<const Rate&>()));

template <class Attitude, class Rate, class Acceleration>
using SecondDerivativeOf = decltype(attitude_second_rate(
    std::declval<const Attitude&>(), std::declval<const Rate&>(), std::declval<const Acceleration&>()));
template <class Attitude, class Rate, class Acceleration>
concept TwiceDerived = requires {
  typename SecondDerivativeOf<Attitude, Rate, Acceleration>;
};

}  // namespace detail

/// The derivative of a rotation, a DcmRate or a QuaternionRate:
///     Body form:       d/dt R_b^a = R_b^a [w_ab^b]x     d/dt q_b^a = 1/2 q_b^a (0, w_ab^b)
///     Reference form:  d/dt R_b^a = [w_ab^a]x R_b^a     d/dt q_b^a = 1/2 (0, w_ab^a) q_b^a
/// Any finite input is valid.
template <class Rotation, class Rate>
[[gnu::always_inline]] inline detail::DerivativeOf<Rotation, Rate> rate(const Rotation& rotation,
                                                                        const Rate& omega) {
  return attitude_rate(rotation, omega);
}
template <class Rotation, class Rate>
  requires(detail::FramedPair<Rotation, Rate> && !detail::Lawful<detail::DerivativeOf, Rotation, Rate>)
auto rate(  // rate(R_a_from_b, w_ab_b) or rate(R_a_from_b, w_ab_a)
    const Rotation&, const Rate&) -> Refused = delete;

template <class Attitude, class Rate, class C>
auto angular_velocity(  // angular_velocity(x_ab, xdot_ab, in<B>) or in<A>; xdot the rate of that x
    const Attitude&, const Rate&, const In<C>&) -> Refused = delete;
template <class Attitude, class Rate, class SecondRate, class C>
auto angular_acceleration(  // angular_acceleration(x_ab, xdot_ab, xddot_ab, in<B>) or in<A>
    const Attitude&, const Rate&, const SecondRate&, const In<C>&) -> Refused = delete;

/// The second derivative of an attitude, from the rate and the angular acceleration, both expressed in b or
/// both in a:
///     d2/dt2 R_b^a = R_b^a ([w]x^2 + [alpha]x) in b, ([w]x^2 + [alpha]x) R_b^a in a
///     d2/dt2 q_b^a = q_b^a (-|w|^2/4, alpha/2) in b, (-|w|^2/4, alpha/2) q_b^a in a
/// For parameters x_ab it is xddot_ab. Any finite input is valid for R and q. Throws BadInput with the
/// distance at the singularity of parameters.
template <class Attitude, class Rate, class Acceleration>
detail::SecondDerivativeOf<Attitude, Rate, Acceleration> second_rate(const Attitude& attitude,
                                                                     const Rate& omega,
                                                                     const Acceleration& alpha) {
  return attitude_second_rate(attitude, omega, alpha);
}
template <class X, class Rate, class Acceleration>
  requires(!detail::TwiceDerived<X, Rate, Acceleration>)
auto second_rate(  // second_rate(x_ab, w_ab_c, alpha_ab_c): both expressed in b, or both in a
    const X&, const Rate&, const Acceleration&) -> Refused = delete;

}  // namespace vectrix
