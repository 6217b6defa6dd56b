#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vectrix/space/orbit/attraction.hpp>
#include <vectrix/space/orbit/two_body.hpp>
#include <vectrix/space/sky/bodies.hpp>

namespace vectrix {
namespace detail {

template <class B> inline constexpr bool is_image = false;
template <class B, class C> inline constexpr bool is_image<sky::Image<B, C>> = true;

}  // namespace detail

namespace sky {

/// The gravitational parameters of the Sun (nominal, IAU 2015, resolution B3) and the Moon (JPL's DE440).
inline constexpr auto sun_mu = Quantity<si::gravitational_parameter>::from_value(1.3271244e20);
inline constexpr auto moon_mu = Quantity<si::gravitational_parameter>::from_value(4.902800118e12);

}  // namespace sky

/// The gravitational parameter of the body b alone.
template <Point B, class S = double> struct GravitationalParameter {
  Quantity<si::gravitational_parameter, S> mu;
};
/// Claims that mu is that of b: gravitational_parameter(of<sky::Jupiter>, mu).
template <class B, class S>
constexpr GravitationalParameter<B, S> gravitational_parameter(
    Of<B>, const Quantity<si::gravitational_parameter, S>& mu) {
  return {mu};
}
template <class B, class Mu>
auto gravitational_parameter(  // of<B>; mu in m^3/s^2
    const B&, const Mu&) -> Refused = delete;

namespace detail {

template <class B> inline constexpr auto known_mu = nullptr;
template <> inline constexpr auto known_mu<sky::Sun> = sky::sun_mu;
template <> inline constexpr auto known_mu<sky::Moon> = sky::moon_mu;
template <class B>
inline constexpr bool has_known_mu = !std::is_same_v<decltype(known_mu<B>), const std::nullptr_t>;

}  // namespace detail

/// What the attraction of a third body b, a point, adds to the acceleration of q relative to p, for an
/// observer whose axes do not turn: of q less that of p,
///     a = mu (r_qb/|r_qb|^3 - r_pb/|r_pb|^3) = -mu/|r_qb|^3 (r_pq + F r_pb),    r_qb = r_pb - r_pq
///     F = x (3 + 3 x + x^2)/(1 + (1 + x)^3/2),    x = r_pq . (r_pq - 2 r_pb)/|r_pb|^2
/// where nothing cancels (Battin, An Introduction to the Mathematics and Methods of Astrodynamics, section
/// 8.4). The Sun and the Moon attract by their own mu, another body by one that says whose it is:
///     third_body_acceleration(r, moon.motion(epoch).position)
///     third_body_acceleration(gravitational_parameter(of<sky::Jupiter>, mu), r, r_jupiter)
/// b is where it is, geometric: its image does not compile. Throws BadInput if mu is not positive, or q or p
/// is at b.
template <class P, class Q, class B, class A, class S>
  requires(!detail::is_image<B>)
detail::IfInertial<A, Acceleration<P, Q, ObservedFrom<A>, In<A>, S>> third_body_acceleration(
    const GravitationalParameter<B, S>& mu_b, const Displacement<P, Q, In<A>, S>& r_pq_a,
    const Displacement<P, B, In<A>, S>& r_pb_a) {
  using std::sqrt;
  const detail::Column<S>&r = r_pq_a.coordinates(), &s = r_pb_a.coordinates();
  const auto name = detail::orbit_of<P, Q>("third_body_acceleration");
  const S distance = sqrt((s - r).squaredNorm());
  detail::attraction<S>(name, mu_b.mu.value(), sqrt(s.squaredNorm()));
  const S pull = detail::attraction<S>(name, mu_b.mu.value(), distance);
  const S x = r.dot(r - S(2) * s) / s.squaredNorm();
  const S root = sqrt(S(1) + x);
  const S F = x * (S(3) + x * (S(3) + x)) / (S(1) + (S(1) + x) * root);
  return Acceleration<P, Q, ObservedFrom<A>, In<A>, S>{detail::trusted,
                                                       detail::Column<S>(-pull * (r + F * s))};
}
template <class P, class Q, class B, class A, class S>
std::enable_if_t<detail::has_known_mu<B>,
                 detail::IfInertial<A, Acceleration<P, Q, ObservedFrom<A>, In<A>, S>>>
third_body_acceleration(const Displacement<P, Q, In<A>, S>& r_pq_a,
                        const Displacement<P, B, In<A>, S>& r_pb_a) {
  const auto mu = Quantity<si::gravitational_parameter, S>::from_value(S(detail::known_mu<B>.value()));
  return third_body_acceleration(gravitational_parameter(of<B>, mu), r_pq_a, r_pb_a);
}
template <class... Given>
auto third_body_acceleration(  // mu of b, r_pq, r_pb: geometric, relative to one p, in an inertial frame
    const Given&...) -> Refused = delete;

}  // namespace vectrix
