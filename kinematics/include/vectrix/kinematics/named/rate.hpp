#pragma once

#include <vectrix/kinematics/named/relative_vector.hpp>

namespace vectrix {

using NamedAngularVelocity = NamedRelativeVector<si::angular_velocity>;
using NamedAngularAcceleration = NamedRelativeVector<si::angular_acceleration>;

template <>
struct detail::ReasonOf<NamedAngularAcceleration, NamedAngularAcceleration>
    : std::type_identity<reason::transport_term_is_lost> {};

namespace detail {

inline void require_other(std::string_view door, NamedFrame b, NamedFrame a) {
  if (b == a) {
    throw BadInput(std::string{door} + "(of " + in_quotes(b) + ", relative to " + in_quotes(a) +
                   "): a frame does not move relative to itself");
  }
}

}  // namespace detail

/// Claims that the vector is the angular velocity (acceleration) of b relative to a.
inline NamedAngularVelocity angular_velocity(Of<NamedFrame> b, RelativeTo<NamedFrame> a,
                                             const NamedVector<si::angular_velocity>& w_ab_c) {
  detail::require_other("angular_velocity", b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, w_ab_c};
}
inline NamedAngularAcceleration angular_acceleration(
    Of<NamedFrame> b, RelativeTo<NamedFrame> a, const NamedVector<si::angular_acceleration>& alpha_ab_c) {
  detail::require_other("angular_acceleration", b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, alpha_ab_c};
}

}  // namespace vectrix
