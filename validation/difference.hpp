#pragma once

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
  void position(const PointMotion<Inertial, CentreOfMassOf<Body>, Inertial>& orbit,
                const Eigen::Vector3d& reference) {
    position_m = detail::larger(position_m, (orbit.position.coordinates() - reference).norm());
  }
};

/// Tolerances of every validated propagation: the tightest that step control in double precision can follow.
inline Propagation<Inertial, Body> tight(double end_s, std::vector<Quantity<si::time>> output_times) {
  return {.end = end_s * si::second,
          .tolerances = {.relative = 1e-14,
                         .attitude = 1e-14,
                         .rate = 1e-17 * (si::radian / si::second),
                         .position = 1e-8 * si::metre,
                         .velocity = 1e-11 * (si::metre / si::second)},
          .output_times = std::move(output_times)};
}

}  // namespace vectrix::validation
