#pragma once

#include <utility>
#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/dynamics/force/gravity.hpp>

#include "rigid_bodies.hpp"

/// A craft of one rigid body, whose frame is at its centre of mass, for comparisons with exact motions. It is
/// so heavy that its size does not move its orbit.
namespace vectrix::test::rigid_craft {

template <class Hub> auto craft_of(const Inertia<Body>& J_b, const Hub& hub) {
  return spacecraft(
      body(mass_properties(1e12 * si::kilogram,
                           coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>), J_b),
           hub));
}
struct Turning : decltype(craft_of(std::declval<Inertia<Body>>(), turning_in<Gcrf>)) {
  explicit Turning(const Inertia<Body>& J_b)
      : decltype(craft_of(J_b, turning_in<Gcrf>))(craft_of(J_b, turning_in<Gcrf>)) {}
};
struct Free : decltype(craft_of(std::declval<Inertia<Body>>(), free_in<Gcrf>)) {
  explicit Free(const Inertia<Body>& J_b)
      : decltype(craft_of(J_b, free_in<Gcrf>))(craft_of(J_b, free_in<Gcrf>)) {}
};

inline Turning turning(const AxisymmetricBody& body) {
  return Turning(tensor(body.a, body.a, body.c));
}
inline Free free(const AxisymmetricBody& body) {
  return Free(tensor(body.a, body.a, body.c));
}

/// The attraction of a point mass without its gradient.
inline auto field_of(double mu) {
  return [mu = Quantity<si::gravitational_parameter>::from_value(mu)](const Now<Free>& now,
                                                                      Forces<Free>& forces) {
    forces.field(point_mass_gravity(mu, now.position(of<Body>, relative_to<Gcrf>, in<Gcrf>).vector()));
  };
}

inline MovingDcm<Gcrf, Body> moving(const BodyState& state) {
  return {state.R_i_from_b(), state.w_ib_b};
}
inline CraftState<Turning> start_of(const Turning& craft, const BodyState& now) {
  return state(craft, now.time, moving(now));
}
/// With r_ib^i and v_ib|i^i of the body's centre of mass.
inline CraftState<Free> start_of(const Free& craft, const BodyState& now, const Eigen::Vector3d& r,
                                 const Eigen::Vector3d& v) {
  return state(
      craft, now.time,
      MovingTransform<Gcrf, Body>{
          moving(now), displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r)),
          velocity(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::velocity>(in<Gcrf>, v))});
}

template <class C> BodyState body_state(const CraftState<C>& state) {
  const MovingDcm<Gcrf, Body> now = state.turning();
  return {state.time(), quaternion(now.rotation), now.angular_velocity};
}

/// The error of a step: 1e-12, and of slow rates 1e-15 rad/s; a micrometre.
inline CraftPropagation until(double end, ode::Method method = ode::Method::verner_9,
                              AttitudeState attitude = AttitudeState::quaternion) {
  return {.end = seconds(end),
          .relative_tolerance = 1e-12,
          .absolute_tolerances = {1e-12 * si::radian, 1e-15 * (si::radian / si::second), 1e-6 * si::metre,
                                  1e-9 * (si::metre / si::second), 1e-12},
          .method = method,
          .attitude = attitude};
}

}  // namespace vectrix::test::rigid_craft
