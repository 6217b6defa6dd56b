#pragma once

#include <type_traits>
#include <utility>

#include <vectrix/space/pointing/pointing.hpp>
#include <vectrix/space/sky/bodies.hpp>

namespace vectrix {
namespace detail {

template <class P>
concept SunPoint = is_sun<P>;

// z to the Earth, and x on the side of the Sun.
template <Frame B, class A, Level level, class S>
auto steered_in_yaw(const MovingDirection<A, level, S>& from_earth_a,
                    const MovingDirection<A, level, S>& to_sun_a) {
  return pointed_by("yaw_steering", align(unit_z<B, S>(in<B>), -from_earth_a),
                    constrain(unit_x<B, S>(in<B>), to_sun_a));
}
template <Frame B, class E, class Q, SunPoint Sun, class A, class S>
auto yaw_steered(const Displacement<E, Q, In<A>, S>& r_eq_a, const Displacement<Q, Sun, In<A>, S>& r_qs_a) {
  return steered_in_yaw<B>(moving_direction(r_eq_a), moving_direction(r_qs_a));
}
template <Frame B, class E, class Q, SunPoint Sun, class A, class S>
auto yaw_steered(const PointMotion<E, Q, A, S>& eq, const PointMotion<Q, Sun, A, S>& qs) {
  return steered_in_yaw<B>(moving_direction(eq), moving_direction(qs));
}
template <Frame B, class E, class Q, SunPoint Sun, class A, class S>
auto yaw_steered(const PointMotion<E, Q, A, S>& eq,
                 const Acceleration<E, Q, ObservedFrom<A>, In<A>, S>& a_eq_a_a,
                 const PointMotion<Q, Sun, A, S>& qs,
                 const Acceleration<Q, Sun, ObservedFrom<A>, In<A>, S>& a_qs_a_a) {
  return steered_in_yaw<B>(moving_direction(eq, a_eq_a_a), moving_direction(qs, a_qs_a_a));
}

// x along the velocity, and z on the side of the Earth.
template <Frame B, class A, Level level, class S>
auto steered_to_zero_doppler(const MovingDirection<A, level, S>& along_a,
                             const MovingDirection<A, level, S>& from_earth_a) {
  return pointed_by("zero_doppler_steering", align(unit_x<B, S>(in<B>), along_a),
                    constrain(unit_z<B, S>(in<B>), -from_earth_a));
}
template <Frame B, class E, class Q, class A, class S>
  requires(!InertialFrame<A>)
auto zero_doppler_steered(const Displacement<E, Q, In<A>, S>& r_eq_a,
                          const Velocity<E, Q, ObservedFrom<A>, In<A>, S>& v_eq_a_a) {
  return steered_to_zero_doppler<B>(moving_direction(v_eq_a_a), moving_direction(r_eq_a));
}
template <Frame B, class E, class Q, class A, class S>
  requires(!InertialFrame<A>)
auto zero_doppler_steered(const Displacement<E, Q, In<A>, S>& r_eq_a,
                          const Velocity<E, Q, ObservedFrom<A>, In<A>, S>& v_eq_a_a,
                          const Acceleration<E, Q, ObservedFrom<A>, In<A>, S>& a_eq_a_a) {
  return steered_to_zero_doppler<B>(moving_direction(v_eq_a_a, a_eq_a_a), moving_direction(r_eq_a, v_eq_a_a));
}
template <Frame B, class E, class Q, class A, class S>
  requires(!InertialFrame<A>)
auto zero_doppler_steered(const Displacement<E, Q, In<A>, S>& r_eq_a,
                          const Velocity<E, Q, ObservedFrom<A>, In<A>, S>& v_eq_a_a,
                          const Acceleration<E, Q, ObservedFrom<A>, In<A>, S>& a_eq_a_a,
                          const Derivative<A, A, si::acceleration, S>& jerk_a_a) {
  return steered_to_zero_doppler<B>(moving_direction(v_eq_a_a, a_eq_a_a, jerk_a_a),
                                    moving_direction(r_eq_a, v_eq_a_a, a_eq_a_a));
}
template <Frame B, class E, class Q, class A, class S, class... Derivatives>
auto zero_doppler_steered(const PointMotion<E, Q, A, S>& motion, const Derivatives&... derivatives)
    -> decltype(zero_doppler_steered<B>(motion.position, motion.velocity, derivatives...)) {
  return zero_doppler_steered<B>(motion.position, motion.velocity, derivatives...);
}

template <class B, class... Given>
using YawSteeredOf =
    std::enable_if_t<!InertialFrame<B>, decltype(yaw_steered<B>(std::declval<const Given&>()...))>;
template <class B, class... Given>
using ZeroDopplerOf =
    std::enable_if_t<!InertialFrame<B>, decltype(zero_doppler_steered<B>(std::declval<const Given&>()...))>;
template <class FromFrame, class... Given> inline constexpr bool steers_in_yaw = false;
template <class B, class... Given>
  requires requires {
    typename YawSteeredOf<B, Given...>;
  }
inline constexpr bool steers_in_yaw<From<B>, Given...> = true;
template <class FromFrame, class... Given> inline constexpr bool steers_to_zero_doppler = false;
template <class B, class... Given>
  requires requires {
    typename ZeroDopplerOf<B, Given...>;
  }
inline constexpr bool steers_to_zero_doppler<From<B>, Given...> = true;

}  // namespace detail

/// Yaw steering, the nominal attitude of navigation satellites: z of the body to the centre e of the Earth,
/// y across the Sun s, sky::Sun or its image, so that panels about y can face it, x on the side of the Sun
/// (the axes of the International GNSS Service). For a satellite q:
///     yaw_steering(from<Body>, r_eq_a, r_qs_a)                        Dcm<A, Body>
///     yaw_steering(from<Body>, motion_eq, motion_qs)                  MovingDcm<A, Body>, of PointMotions
///     yaw_steering(from<Body>, motion_eq, a_eq, motion_qs, a_qs)      AcceleratingDcm<A, Body>
/// Singular where Earth, satellite and Sun are on a line, at noon and midnight in orbits whose plane has the
/// Sun in it. Near it the yaw rate exceeds what satellites can do, and they follow laws of their own. Throws
/// BadInput if the sine of the angle between Earth and Sun is below nearly_one_direction.
template <class B, class... Given>
detail::YawSteeredOf<B, Given...> yaw_steering(From<B>, const Given&... given) {
  return detail::yaw_steered<B>(given...);
}
template <class FromFrame, class... Given>
  requires(!detail::steers_in_yaw<FromFrame, Given...>)
auto yaw_steering(  // from<B>: not inertial; satellite from the Earth, then the Sun from the satellite: in
                    // one a
    FromFrame, const Given&...) -> Refused = delete;

/// Zero-Doppler steering of a radar: x of the body along the velocity that the Earth sees, z as near as
/// possible to the centre of the Earth. What x is normal to has no Doppler shift. The motion is observed from
/// the Earth-fixed frame a, in a:
///     zero_doppler_steering(from<Body>, r_eq_a, v_eq_a_a)                         Dcm<A, Body>
///     zero_doppler_steering(from<Body>, r_eq_a, v_eq_a_a, a_eq_a_a)               MovingDcm<A, Body>
///     zero_doppler_steering(from<Body>, r_eq_a, v_eq_a_a, a_eq_a_a, jerk_a_a)     AcceleratingDcm<A, Body>
/// A PointMotion may stand for r and v. The rates are relative to a: a frame graph adds the Earth's. Throws
/// BadInput if the sine of the angle between r and v is below nearly_one_direction.
template <class B, class... Given>
detail::ZeroDopplerOf<B, Given...> zero_doppler_steering(From<B>, const Given&... given) {
  return detail::zero_doppler_steered<B>(given...);
}
template <class FromFrame, class... Given>
  requires(!detail::steers_to_zero_doppler<FromFrame, Given...>)
auto zero_doppler_steering(  // from<B>; r, v, then a and da/dt: observed from the Earth-fixed frame a, in a
    FromFrame, const Given&...) -> Refused = delete;

}  // namespace vectrix
