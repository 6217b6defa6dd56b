#pragma once

#include <vectrix/dynamics.hpp>

#include "simbody_reference.hpp"

namespace vectrix::validation {

namespace detail {

inline Vector3 array(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline Matrix3 row_major(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

template <class C>
inline constexpr bool is_one_free_body = C::shape::free&& C::state_size == C::shape::hub_size;

}  // namespace detail

/// The same body in Simbody's form, in an orbit about a point mass, without what else acts on it. Simbody's
/// orbit is that of a point.
template <CraftType C>
  requires(detail::is_one_free_body<C>)
SimbodyBody simbody_body(const C& craft, const CraftState<C>& start,
                         const Quantity<si::gravitational_parameter>& mu) {
  const auto now = start.hub_motion();
  return {.mass_kg = 1000.0,  // any value: the mass does not affect the orbit about a point mass
          .inertia_tensor_b = detail::row_major(plain(craft).J_c_h),
          .R_i_from_b = detail::row_major(now.turning.rotation.matrix()),
          .w_ib_b = detail::array(now.turning.angular_velocity.coordinates()),
          .orbit = SimbodyOrbit{mu.value(), detail::array(now.translation.coordinates()),
                                detail::array(now.velocity.coordinates())},
          .pulses = {}};
}

}  // namespace vectrix::validation
