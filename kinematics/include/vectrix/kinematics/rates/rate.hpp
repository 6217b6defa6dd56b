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

template <class Attitude, class Rate, class Expressed>
using VelocityFrom = decltype(attitude_velocity(std::declval<const Attitude&>(), std::declval<const Rate&>(),
                                                std::declval<Expressed>()));
template <class Attitude, class Rate, class Expressed>
concept GivesVelocity = requires {
  typename VelocityFrom<Attitude, Rate, Expressed>;
};
template <class Attitude, class Rate, class SecondRate, class Expressed>
using AccelerationFrom =
    decltype(attitude_acceleration(std::declval<const Attitude&>(), std::declval<const Rate&>(),
                                   std::declval<const SecondRate&>(), std::declval<Expressed>()));
template <class Attitude, class Rate, class SecondRate, class Expressed>
concept GivesAcceleration = requires {
  typename AccelerationFrom<Attitude, Rate, SecondRate, Expressed>;
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

/// The inverse of rate(): w_ab^c from an attitude x_ab and its derivative, where c is b or a. The attitude is
/// a Dcm, a Quaternion, or parameters:
///     w_ab^b = vee(R^T Rdot) in b, vee(Rdot R^T) in a       (0, w_ab^b) = 2 q* qdot in b, 2 qdot q* in a
/// Throws BadInput when R and Rdot, or q and qdot, are inconsistent: R^T Rdot is not skew, or the norm of q
/// would leave 1. Any finite input is valid for parameters, also at the singularity.
template <class Attitude, class Rate, class C>
detail::VelocityFrom<Attitude, Rate, In<C>> angular_velocity_from(const Attitude& x_ab, const Rate& xdot_ab,
                                                                  In<C> in_c) {
  return attitude_velocity(x_ab, xdot_ab, in_c);
}
template <class Attitude, class Rate, class Expressed>
  requires(!detail::GivesVelocity<Attitude, Rate, Expressed>)
auto angular_velocity_from(  // angular_velocity_from(x_ab, xdot_ab, in<B>) or in<A>; xdot the rate of that x
    const Attitude&, const Rate&, const Expressed&) -> Refused = delete;

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

/// The inverse of second_rate(): alpha_ab^c from an attitude x_ab and both derivatives, where c is b or a:
///     alpha_ab^b = vee(R^T Rddot - [w_ab^b]x^2)      (-|w|^2/2, alpha_ab^b) = 2 q* qddot      and likewise
///     in a
/// Throws BadInput when the three are inconsistent, by more than 1e-9 of the largest number. Any finite input
/// is valid for parameters, also at the singularity.
template <class Attitude, class Rate, class SecondRate, class C>
detail::AccelerationFrom<Attitude, Rate, SecondRate, In<C>> angular_acceleration_from(
    const Attitude& x_ab, const Rate& xdot_ab, const SecondRate& xddot_ab, In<C> in_c) {
  return attitude_acceleration(x_ab, xdot_ab, xddot_ab, in_c);
}
template <class Attitude, class Rate, class SecondRate, class Expressed>
  requires(!detail::GivesAcceleration<Attitude, Rate, SecondRate, Expressed>)
auto angular_acceleration_from(  // angular_acceleration_from(x_ab, xdot_ab, xddot_ab, in<B>) or in<A>
    const Attitude&, const Rate&, const SecondRate&, const Expressed&) -> Refused = delete;

}  // namespace vectrix
