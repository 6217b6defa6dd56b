#pragma once

#include <array>
#include <vector>

namespace vectrix::validation {

/// A body about its own origin: matrices by rows, SI units.
struct SimbodyScanBody {
  double mass_kg;
  std::array<double, 3> centre_b;
  std::array<double, 9> inertia_c_b;  ///< about the centre of mass
};
/// A free hub, at rest in place, with a mirror on a pin that Simbody's own Motion::Sinusoid turns:
///     q = amplitude sin(rate t + phase)
struct SimbodyScan {
  SimbodyScanBody hub, mirror;
  std::array<double, 9> R_h_from_m;
  std::array<double, 3> r_hm_h, axis_m, w_ih_h;
  double amplitude, rate, phase;
};
struct SimbodyScanSample {
  double t_s;
  std::array<double, 9> R_i_from_h;
  std::array<double, 3> w_ih_h;
  double angle, torque_nm;  ///< of the motion
};

/// At the times, from 0 on; `steps` counts those of the integrator.
std::vector<SimbodyScanSample> simbody_scan(const SimbodyScan& scan, double accuracy,
                                            const std::vector<double>& times_s, long& steps);

}  // namespace vectrix::validation
