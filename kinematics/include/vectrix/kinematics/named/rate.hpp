#pragma once

#include <vectrix/kinematics/named/relative_vector.hpp>

namespace vectrix {

using NamedAngularVelocity = NamedRelativeVector<si::angular_velocity>;
using NamedAngularAcceleration = NamedRelativeVector<si::angular_acceleration>;

template <>
struct detail::ReasonOf<NamedAngularAcceleration, NamedAngularAcceleration>
    : std::type_identity<reason::transport_term_is_lost> {};

namespace detail {

inline void require_other(NamedFrame b, NamedFrame a) {
  if (b == a) {
    throw BadInput("of " + in_quotes(b) + " relative to " + in_quotes(a) +
                   ": a frame does not move relative to itself");
  }
}

}  // namespace detail

/// Claims that the vector is the angular velocity (acceleration) of b relative to a.
inline NamedAngularVelocity angular_velocity(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                             const NamedVector<si::angular_velocity>& w_ab_c) {
  detail::require_other(b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, w_ab_c};
}
inline NamedAngularAcceleration angular_acceleration(
    Of<NamedFrame> b, RelativeTo<NamedFrame> a, const NamedVector<si::angular_acceleration>& alpha_ab_c) {
  detail::require_other(b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, alpha_ab_c};
}

/// alpha_ad^c = alpha_ab^c + alpha_bd^c + w_ab^c x w_bd^c, all four expressed in c.
inline NamedAngularAcceleration chain(const NamedAngularAcceleration& alpha_ab,
                                      const NamedAngularAcceleration& alpha_bd,
                                      const NamedAngularVelocity& w_ab, const NamedAngularVelocity& w_bd) {
  const auto action = [&] {
    return "chain of " + detail::described(alpha_ab) + ", " + detail::described(alpha_bd) + ", " +
           detail::described(w_ab) + ", " + detail::described(w_bd);
  };
  detail::require_same(alpha_ab.of(), alpha_bd.relative_to(), action);
  detail::require_same(w_ab.of(), alpha_ab.of(), action);
  detail::require_same(w_ab.relative_to(), alpha_ab.relative_to(), action);
  detail::require_same(w_bd.of(), alpha_bd.of(), action);
  detail::require_same(w_bd.relative_to(), alpha_bd.relative_to(), action);
  for (const NamedFrame in : {alpha_bd.in(), w_ab.in(), w_bd.in()})
    detail::require_same(alpha_ab.in(), in, action);
  const NamedVector<si::angular_acceleration> cross{detail::trusted, w_ab.in(),
                                                    w_ab.coordinates().cross(w_bd.coordinates())};
  return {detail::trusted, alpha_bd.of(), alpha_ab.relative_to(),
          alpha_ab.vector() + alpha_bd.vector() + cross};
}

}  // namespace vectrix
