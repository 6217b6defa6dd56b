#pragma once

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/kinematics/rates/angular_acceleration.hpp>

namespace vectrix {

/// The rotation and the rate of b relative to a at one instant: R_b^a and w_ab^b. The second level of a graph
/// edge.
///     (R_b^a, w_ab^b) * (R_d^b, w_bd^d) = (R_b^a R_d^b, R_b^d w_ab^b + w_bd^d)
/// Any pair is valid, so it is an aggregate. `MovingDcm{turned_z(to<A>, from<B>, angle), w_ab_b}` builds its
/// members in place.
template <Frame A, Frame B, class S = double> struct MovingDcm {
  Dcm<A, B, S> rotation;
  AngularVelocity<A, B, In<B>, S> angular_velocity;
};
template <class A, class B, class S, class Rate>
MovingDcm(const Dcm<A, B, S>&, const Rate&) -> MovingDcm<A, B, S>;

template <class A, class B, class S> inline constexpr bool detail::is_framed<MovingDcm<A, B, S>> = true;

/// The rotation, rate and acceleration of b relative to a at one instant: R_b^a, w_ab^b and alpha_ab^b. The
/// third level.
///     alpha_ad^d = R_b^d alpha_ab^b + alpha_bd^d + (R_b^d w_ab^b) x w_bd^d
template <Frame A, Frame B, class S = double> struct AcceleratingDcm {
  Dcm<A, B, S> rotation;
  AngularVelocity<A, B, In<B>, S> angular_velocity;
  AngularAcceleration<A, B, In<B>, S> angular_acceleration;
};
template <class A, class B, class S, class Rate, class Change>
AcceleratingDcm(const Dcm<A, B, S>&, const Rate&, const Change&) -> AcceleratingDcm<A, B, S>;

template <class A, class B, class S> inline constexpr bool detail::is_framed<AcceleratingDcm<A, B, S>> = true;

/// Joins a rotation and its rate; the rate may be expressed in b or in a.
template <class A, class B, class S>
MovingDcm<A, B, S> moving_dcm(const Dcm<A, B, S>& R_a_from_b, const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  return MovingDcm<A, B, S>{R_a_from_b, w_ab_b};
}
template <class A, class B, class S>
  requires(!std::same_as<A, B>)
MovingDcm<A, B, S> moving_dcm(const Dcm<A, B, S>& R_a_from_b, const AngularVelocity<A, B, In<A>, S>& w_ab_a) {
  return {R_a_from_b, inverse(R_a_from_b) * w_ab_a};
}
/// The motion without its acceleration.
template <class A, class B, class S>
MovingDcm<A, B, S> without_acceleration(const AcceleratingDcm<A, B, S>& ab) {
  return {ab.rotation, ab.angular_velocity};
}
template <class DcmTo, class DcmFrom, class RateRelativeTo, class RateOf, class RateIn, class S>
  requires(!(std::same_as<DcmTo, RateRelativeTo> && std::same_as<DcmFrom, RateOf> &&
             (std::same_as<RateIn, RateOf> || std::same_as<RateIn, RateRelativeTo>)))
auto moving_dcm(  // moving_dcm(R_a_from_b, w_ab_b) or (R_a_from_b, w_ab_a)
    const Dcm<DcmTo, DcmFrom, S>&, const AngularVelocity<RateRelativeTo, RateOf, In<RateIn>, S>&)
    -> Refused = delete;

/// Joins a rotation, its rate and its acceleration, the last two expressed in b.
template <class A, class B, class S>
AcceleratingDcm<A, B, S> accelerating_dcm(const Dcm<A, B, S>& R_a_from_b,
                                          const AngularVelocity<A, B, In<B>, S>& w_ab_b,
                                          const AngularAcceleration<A, B, In<B>, S>& alpha_ab_b) {
  return AcceleratingDcm<A, B, S>{R_a_from_b, w_ab_b, alpha_ab_b};
}

template <class A, class B, class D, class S>
MovingDcm<A, D, S> product(const MovingDcm<A, B, S>& ab, const MovingDcm<B, D, S>& bd) {
  return {detail::composed(ab.rotation, bd.rotation),
          inverse(bd.rotation) * ab.angular_velocity + bd.angular_velocity};
}
template <class A, class B, class D, class S>
AcceleratingDcm<A, D, S> product(const AcceleratingDcm<A, B, S>& ab, const AcceleratingDcm<B, D, S>& bd) {
  const auto R_d_from_b = inverse(bd.rotation);
  const auto w_ab_d = R_d_from_b * ab.angular_velocity;
  return {detail::composed(ab.rotation, bd.rotation), w_ab_d + bd.angular_velocity,
          chain(R_d_from_b * ab.angular_acceleration, bd.angular_acceleration, w_ab_d, bd.angular_velocity)};
}

// w_ba^a = -R_b^a w_ab^b, and the same for alpha
template <class A, class B, class S> MovingDcm<B, A, S> inverse(const MovingDcm<A, B, S>& ab) {
  return {inverse(ab.rotation), -(ab.rotation * ab.angular_velocity)};
}
template <class A, class B, class S> AcceleratingDcm<B, A, S> inverse(const AcceleratingDcm<A, B, S>& ab) {
  return {inverse(ab.rotation), -(ab.rotation * ab.angular_velocity),
          -(ab.rotation * ab.angular_acceleration)};
}

// Steps of a frame graph's walk between a and b: along an edge with the motion of b relative to a, R_b^a and
// w_ab^b, or against an edge with the motion of a relative to b.
//
// From x over a to b:    w_xb^b = R_a^b w_xa^a + w_ab^b      w_xb^b = R_a^b (w_xa^a - w_ba^a)
template <class A, class B, class S>
AngularVelocity<A, B, In<B>, S> rate_along(const Dcm<A, B, S>&,
                                           const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  return w_ab_b;
}
template <class X, class A, class B, class S>
AngularVelocity<X, B, In<B>, S> rate_along(const Dcm<A, B, S>& R_a_from_b,
                                           const AngularVelocity<A, B, In<B>, S>& w_ab_b,
                                           const AngularVelocity<X, A, In<A>, S>& w_xa_a) {
  return inverse(R_a_from_b) * w_xa_a + w_ab_b;
}
template <class A, class B, class S>
AngularVelocity<A, B, In<B>, S> rate_against(const Dcm<B, A, S>& R_b_from_a,
                                             const AngularVelocity<B, A, In<A>, S>& w_ba_a) {
  return R_b_from_a * -w_ba_a;
}
template <class X, class A, class B, class S>
AngularVelocity<X, B, In<B>, S> rate_against(const Dcm<B, A, S>& R_b_from_a,
                                             const AngularVelocity<B, A, In<A>, S>& w_ba_a,
                                             const AngularVelocity<X, A, In<A>, S>& w_xa_a) {
  return AngularVelocity<X, B, In<B>, S>{detail::trusted, R_b_from_a * (w_xa_a.vector() - w_ba_a.vector())};
}
// From y over b back to a:    w_ay^a = R_b^a (w_ab^b + w_by^b)    w_ay^a = R_b^a w_by^b - w_ba^a
template <class A, class B, class S>
AngularVelocity<A, B, In<A>, S> rate_back_along(const Dcm<A, B, S>& R_a_from_b,
                                                const AngularVelocity<A, B, In<B>, S>& w_ab_b) {
  return R_a_from_b * w_ab_b;
}
template <class A, class B, class Y, class S>
AngularVelocity<A, Y, In<A>, S> rate_back_along(const Dcm<A, B, S>& R_a_from_b,
                                                const AngularVelocity<A, B, In<B>, S>& w_ab_b,
                                                const AngularVelocity<B, Y, In<B>, S>& w_by_b) {
  return R_a_from_b * (w_ab_b + w_by_b);
}
template <class A, class B, class S>
AngularVelocity<A, B, In<A>, S> rate_back_against(const Dcm<B, A, S>&,
                                                  const AngularVelocity<B, A, In<A>, S>& w_ba_a) {
  return -w_ba_a;
}
template <class A, class B, class Y, class S>
AngularVelocity<A, Y, In<A>, S> rate_back_against(const Dcm<B, A, S>& R_b_from_a,
                                                  const AngularVelocity<B, A, In<A>, S>& w_ba_a,
                                                  const AngularVelocity<B, Y, In<B>, S>& w_by_b) {
  return AngularVelocity<A, Y, In<A>, S>{detail::trusted,
                                         inverse(R_b_from_a) * w_by_b.vector() - w_ba_a.vector()};
}

// What a frame graph needs of the values on its edges.
template <class A, class B, class S>
struct LevelOf<MovingDcm<A, B, S>> : detail::TurningLevel<A, B, S, Level::rate> {};
template <class A, class B, class S>
struct LevelOf<AcceleratingDcm<A, B, S>> : detail::TurningLevel<A, B, S, Level::acceleration> {};
template <class A, class B, class S> const Dcm<A, B, S>& rotation_of(const MovingDcm<A, B, S>& value) {
  return value.rotation;
}
template <class A, class B, class S> const Dcm<A, B, S>& rotation_of(const AcceleratingDcm<A, B, S>& value) {
  return value.rotation;
}
template <class A, class B, class S>
const AcceleratingDcm<A, B, S>& accelerating_part(const AcceleratingDcm<A, B, S>& value) {
  return value;
}
template <class A, class B, class S>
const AngularVelocity<A, B, In<B>, S>& angular_velocity_of(const MovingDcm<A, B, S>& value) {
  return value.angular_velocity;
}
template <class A, class B, class S>
const AngularVelocity<A, B, In<B>, S>& angular_velocity_of(const AcceleratingDcm<A, B, S>& value) {
  return value.angular_velocity;
}
template <class A, class B, class S>
const AngularAcceleration<A, B, In<B>, S>& angular_acceleration_of(const AcceleratingDcm<A, B, S>& value) {
  return value.angular_acceleration;
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const MovingDcm<A, B, S>& value) {
  return out << value.rotation << "; " << value.angular_velocity;
}
template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const AcceleratingDcm<A, B, S>& value) {
  return out << value.rotation << "; " << value.angular_velocity << "; " << value.angular_acceleration;
}

}  // namespace vectrix
