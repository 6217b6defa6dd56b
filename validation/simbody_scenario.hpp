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

}  // namespace detail

/// The same scenario in Simbody's form. Throws BadInput for a custom torque, which Simbody does not have.
template <class I, class B> SimbodyBody simbody_body(const Scenario<I, B>& scenario) {
  if (!scenario.torques.empty()) {
    throw BadInput("simbody_body: the scenario has " + vectrix::detail::text(scenario.torques.size()) +
                   " custom torques; Simbody takes pulses and the gravity gradient");
  }
  SimbodyBody body{.mass_kg = 1000.0,  // any value: the mass does not affect the orbit about a point mass
                   .inertia_tensor_b = detail::row_major(scenario.inertia.matrix()),
                   .R_i_from_b = detail::row_major(scenario.initial.R_i_from_b().matrix()),
                   .w_ib_b = detail::array(scenario.initial.w_ib_b.coordinates()),
                   .orbit = {},
                   .pulses = {},
                   .gravity_gradient = scenario.gravity_gradient};
  if (scenario.initial.orbit) {
    body.orbit =
        SimbodyOrbit{scenario.mu->value(), detail::array(scenario.initial.orbit->position.coordinates()),
                     detail::array(scenario.initial.orbit->velocity.coordinates())};
  }
  for (const PulseTorque<B>& pulse : scenario.pulses) {
    body.pulses.push_back(
        {pulse.start.value(), pulse.stop.value(), detail::array(pulse.torque_b.coordinates())});
  }
  return body;
}

}  // namespace vectrix::validation
