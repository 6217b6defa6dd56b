#pragma once

#include <vectrix/kinematics/named/relative_vector.hpp>

namespace vectrix {

/// r_pq^c, v_pq|a^c and a_pq|a^c of the origins of frames known at run time.
using NamedDisplacement = NamedRelativeVector<si::length>;
using NamedVelocity = NamedObservedVector<si::velocity>;
using NamedAcceleration = NamedObservedVector<si::acceleration>;

namespace detail {

inline void require_two_points(std::string_view door, NamedFrame q, NamedFrame p) {
  if (q == p) {
    throw BadInput(std::string{door} + "(of " + in_quotes(q) + ", relative to " + in_quotes(p) +
                   "): a door takes two points, and these are one");
  }
}

}  // namespace detail

/// Claims that the vector is the position of q relative to p.
inline NamedDisplacement displacement(Of<NamedFrame> q, RelativeTo<NamedFrame> p,
                                      const NamedVector<si::length>& r_pq_c) {
  detail::require_two_points("displacement", q.frame, p.frame);
  return {detail::trusted, q.frame, p.frame, r_pq_c};
}

/// Claims that the vector is the velocity (acceleration) of q relative to p, observed from a.
inline NamedVelocity velocity(Of<NamedFrame> q, RelativeTo<NamedFrame> p, ObservedFrom<NamedFrame> a,
                              const NamedVector<si::velocity>& v_pq_a_c) {
  detail::require_two_points("velocity", q.frame, p.frame);
  return {detail::trusted, q.frame, p.frame, a.frame, v_pq_a_c};
}
inline NamedAcceleration acceleration(Of<NamedFrame> q, RelativeTo<NamedFrame> p, ObservedFrom<NamedFrame> a,
                                      const NamedVector<si::acceleration>& a_pq_a_c) {
  detail::require_two_points("acceleration", q.frame, p.frame);
  return {detail::trusted, q.frame, p.frame, a.frame, a_pq_a_c};
}
}  // namespace vectrix
