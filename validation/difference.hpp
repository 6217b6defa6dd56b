#pragma once

#include <utility>
#include <vectrix/dynamics.hpp>
#include <vectrix/frames/scalar/larger.hpp>

namespace vectrix::validation {

struct Inertial : inertial_frame {};
struct Lvlh : moving_frame {};
struct Body : moving_frame {};

/// The largest differences so far between two motions of the same body.
struct Difference {
  double attitude_rad = 0.0;
  double rate_rad_s = 0.0;
  double position_m = 0.0;

  /// The angle between two attitudes is the norm of log(R_1^T R_2).
  void attitude(const Dcm<Inertial, Body>& R_i_from_b, const Eigen::Matrix3d& reference) {
    const Dcm<Body, Body> between =
        inverse(R_i_from_b) * nearest_dcm(to<Inertial>, from<Body>, reference).dcm;
    attitude_rad = detail::larger(attitude_rad, log(between).angle().value());
  }
  void rate(const AngularVelocity<Inertial, Body, In<Body>>& w_ib_b, const Eigen::Vector3d& reference) {
    rate_rad_s = detail::larger(rate_rad_s, (w_ib_b.coordinates() - reference).norm());
  }
  void position(const Displacement<Inertial, Body, In<Inertial>>& r_ib_i, const Eigen::Vector3d& reference) {
    position_m = detail::larger(position_m, (r_ib_i.coordinates() - reference).norm());
  }
};

/// A craft of one body, its frame at its centre of mass. It is so heavy that its size does not move its
/// orbit: the references have orbits of points.
template <class Hub> auto craft_of(const Inertia<Body>& J_b, const Hub& hub) {
  return spacecraft(
      body(mass_properties(1e12 * si::kilogram,
                           coincident(of<CentreOfMassOf<Body>>, relative_to<Body>, in<Body>), J_b),
           hub));
}
using Turning = decltype(craft_of(std::declval<Inertia<Body>>(), turning_in<Inertial>));
using Satellite = decltype(craft_of(std::declval<Inertia<Body>>(), free_in<Inertial>));

/// The motion of a hub at the start of a run.
inline MovingDcm<Inertial, Body> moving(const State<Inertial, Body>& start) {
  return {start.R_i_from_b(), start.w_ib_b};
}
inline MovingTransform<Inertial, Body> moving(const State<Inertial, Body>& start,
                                              const Vector<Inertial, si::length>& r_i,
                                              const Vector<Inertial, si::velocity>& v_i) {
  return {moving(start), displacement(of<Body>, relative_to<Inertial>, r_i),
          velocity(of<Body>, relative_to<Inertial>, observed_from<Inertial>, v_i)};
}

/// The attraction of a point mass without its gradient.
template <CraftType C = Satellite> auto point_field(const Quantity<si::gravitational_parameter>& mu) {
  return [mu](const Now<C>& now, Forces<C>& forces) {
    forces.field(
        point_mass_gravity(mu, now.position(of<Body>, relative_to<Inertial>, in<Inertial>).vector()));
  };
}

/// Tolerances of every validated propagation: the tightest that step control in double precision can follow.
inline CraftPropagation tight(double end_s) {
  return {.end = end_s * si::second,
          .relative_tolerance = 1e-14,
          .absolute_tolerances = {.angle = 1e-14 * si::radian,
                                  .rate = 1e-17 * (si::radian / si::second),
                                  .length = 1e-8 * si::metre,
                                  .velocity = 1e-11 * (si::metre / si::second),
                                  .mode = 1e-14}};
}

}  // namespace vectrix::validation
