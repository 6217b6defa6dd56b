#pragma once

#include <vectrix/frames/transform.hpp>
#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>

namespace vectrix {

/// Position and motion of the frame b relative to a at one instant, observed from a: R_b^a and w_ab^b,
/// r_ab^a, and v_ab|a^a of b's origin. Motions multiply as transforms do, X_ad = X_ab X_bd:
///     r_ad = r_ab + R_b^a r_bd,  v_ad|a = v_ab|a + R_b^a (v_bd|b + w_ab x r_bd)
template <Frame A, Frame B, class S = double> struct MovingTransform {
  MovingDcm<A, B, S> turning;
  Displacement<A, B, In<A>, S> translation;
  Velocity<A, B, ObservedFrom<A>, In<A>, S> velocity;
};
template <class A, class B, class S, class Translation, class Motion>
MovingTransform(const MovingDcm<A, B, S>&, const Translation&, const Motion&) -> MovingTransform<A, B, S>;

template <class A, class B, class S> inline constexpr bool detail::is_framed<MovingTransform<A, B, S>> = true;

/// The same with alpha_ab^b and the acceleration a_ab|a^a of b's origin:
///     a_ad|a = a_ab|a + R_b^a (a_bd|b + alpha_ab x r_bd + 2 w_ab x v_bd|b + w_ab x (w_ab x r_bd))
template <Frame A, Frame B, class S = double> struct AcceleratingTransform {
  AcceleratingDcm<A, B, S> turning;
  Displacement<A, B, In<A>, S> translation;
  Velocity<A, B, ObservedFrom<A>, In<A>, S> velocity;
  Acceleration<A, B, ObservedFrom<A>, In<A>, S> acceleration;
};
template <class A, class B, class S, class Translation, class Motion, class Change>
AcceleratingTransform(const AcceleratingDcm<A, B, S>&, const Translation&, const Motion&, const Change&)
    -> AcceleratingTransform<A, B, S>;

template <class A, class B, class S>
inline constexpr bool detail::is_framed<AcceleratingTransform<A, B, S>> = true;

// What a frame graph needs of the values on its edges.
template <class A, class B, class S>
struct LevelOf<MovingTransform<A, B, S>> : detail::PlacedLevel<A, B, S, Level::rate> {};
template <class A, class B, class S>
struct LevelOf<AcceleratingTransform<A, B, S>> : detail::PlacedLevel<A, B, S, Level::acceleration> {};

template <class A, class B, class S> const Dcm<A, B, S>& rotation_of(const MovingTransform<A, B, S>& value) {
  return value.turning.rotation;
}
template <class A, class B, class S>
const Dcm<A, B, S>& rotation_of(const AcceleratingTransform<A, B, S>& value) {
  return rotation_of(value.turning);
}
template <class A, class B, class S>
const AngularVelocity<A, B, In<B>, S>& angular_velocity_of(const MovingTransform<A, B, S>& value) {
  return value.turning.angular_velocity;
}
template <class A, class B, class S>
const AngularVelocity<A, B, In<B>, S>& angular_velocity_of(const AcceleratingTransform<A, B, S>& value) {
  return value.turning.angular_velocity;
}
template <class A, class B, class S>
const AngularAcceleration<A, B, In<B>, S>& angular_acceleration_of(
    const AcceleratingTransform<A, B, S>& value) {
  return value.turning.angular_acceleration;
}
template <class A, class B, class S>
const AcceleratingDcm<A, B, S>& accelerating_part(const AcceleratingTransform<A, B, S>& value) {
  return value.turning;
}
/// The rotation and the position, without their motion.
template <class A, class B, class S> Transform<A, B, S> transform_of(const MovingTransform<A, B, S>& value) {
  return {value.turning.rotation, value.translation};
}
template <class A, class B, class S>
Transform<A, B, S> transform_of(const AcceleratingTransform<A, B, S>& value) {
  return {rotation_of(value), value.translation};
}
/// The motion without its accelerations.
template <class A, class B, class S>
const MovingTransform<A, B, S>& moving_transform_of(const MovingTransform<A, B, S>& value) {
  return value;
}
template <class A, class B, class S>
MovingTransform<A, B, S> moving_transform_of(const AcceleratingTransform<A, B, S>& value) {
  return {without_acceleration(value.turning), value.translation, value.velocity};
}

template <class A, class B, class D, class S>
MovingTransform<A, D, S> product(const MovingTransform<A, B, S>& ab, const MovingTransform<B, D, S>& bd) {
  const auto& R_a_from_b = ab.turning.rotation;
  const auto v_bd_a_b = transport(observed_from<A>, bd.velocity, bd.translation, ab.turning.angular_velocity);
  return {ab.turning * bd.turning, ab.translation + R_a_from_b * bd.translation,
          ab.velocity + R_a_from_b * v_bd_a_b};
}
template <class A, class B, class D, class S>
AcceleratingTransform<A, D, S> product(const AcceleratingTransform<A, B, S>& ab,
                                       const AcceleratingTransform<B, D, S>& bd) {
  const auto& R_a_from_b = rotation_of(ab);
  const auto& w_ab_b = ab.turning.angular_velocity;
  const auto v_bd_a_b = transport(observed_from<A>, bd.velocity, bd.translation, w_ab_b);
  const auto a_bd_a_b = transport(observed_from<A>, bd.acceleration, bd.velocity, bd.translation,
                                  ab.turning.angular_acceleration, w_ab_b);
  return {ab.turning * bd.turning, ab.translation + R_a_from_b * bd.translation,
          ab.velocity + R_a_from_b * v_bd_a_b, ab.acceleration + R_a_from_b * a_bd_a_b};
}

template <class A, class B, class S> MovingTransform<B, A, S> inverse(const MovingTransform<A, B, S>& ab) {
  const auto R_b_from_a = inverse(ab.turning.rotation);
  const auto r_ba_b = R_b_from_a * -ab.translation;
  return {inverse(ab.turning), r_ba_b,
          transport(observed_from<B>, R_b_from_a * -ab.velocity, r_ba_b, -ab.turning.angular_velocity)};
}
template <class A, class B, class S>
AcceleratingTransform<B, A, S> inverse(const AcceleratingTransform<A, B, S>& ab) {
  const auto R_b_from_a = inverse(rotation_of(ab));
  const auto r_ba_b = R_b_from_a * -ab.translation;
  const auto v_ba_a_b = R_b_from_a * -ab.velocity;
  const auto w_ba_b = -ab.turning.angular_velocity;
  return {inverse(ab.turning), r_ba_b, transport(observed_from<B>, v_ba_a_b, r_ba_b, w_ba_b),
          transport(observed_from<B>, R_b_from_a * -ab.acceleration, v_ba_a_b, r_ba_b,
                    -ab.turning.angular_acceleration, w_ba_b)};
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const MovingTransform<A, B, S>& value) {
  return out << value.turning << "; " << value.translation << "; " << value.velocity;
}
template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const AcceleratingTransform<A, B, S>& value) {
  return out << value.turning << "; " << value.translation << "; " << value.velocity << "; "
             << value.acceleration;
}

}  // namespace vectrix
