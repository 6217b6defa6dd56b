#pragma once

#include <array>
#include <optional>
#include <vector>

namespace vectrix::validation {

/// A body about its own origin: matrices by rows, SI units.
struct SimbodyScanBody {
  double mass_kg;
  std::array<double, 3> centre_b;
  std::array<double, 9> inertia_c_b;  ///< about the centre of mass
};
/// Simbody's own Motion::Sinusoid: amplitude sin(rate t + phase).
struct SimbodySine {
  double amplitude, rate, phase;
};
/// A wheel of its own mass on the hub, whose speed is a sine.
struct SimbodyScanWheel {
  SimbodyScanBody body;
  std::array<double, 3> r_hw_h, axis_h;
  SimbodySine speed;
};
/// A free hub, at rest in place, with a mirror on a pin whose angle is a sine. With a second axis the mirror
/// is on a gimbal, free about that, which is fixed in it, and driven about the first, fixed in the hub.
struct SimbodyScan {
  SimbodyScanBody hub, mirror;
  std::array<double, 9> R_h_from_m;
  std::array<double, 3> r_hm_h, axis_m, w_ih_h;
  SimbodySine angle;
  std::optional<std::array<double, 3>> free_axis_m = {};
  std::optional<SimbodyScanWheel> wheel = {};
};
struct SimbodyScanSample {
  double t_s;
  std::array<double, 9> R_i_from_h;
  std::array<double, 3> w_ih_h;
  double angle, torque_nm;  ///< of the motion
  double free_angle = 0.0, free_rate = 0.0, spin = 0.0, wheel_torque_nm = 0.0;
};

/// At the times, from 0 on; `steps` counts those of the integrator.
std::vector<SimbodyScanSample> simbody_scan(const SimbodyScan& scan, double accuracy,
                                            const std::vector<double>& times_s, long& steps);

}  // namespace vectrix::validation
