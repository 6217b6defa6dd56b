#pragma once

#include <array>
#include <optional>
#include <vector>

/// A rigid body propagated by Simbody, an independent multibody engine, behind plain types.
///
/// No type here is from Vectrix, Eigen or Simbody. So a C++20 program can include this header, while the
/// adapter itself is compiled as C++17 (Simbody 3.7's headers are not C++20). SI units. Matrices are
/// row-major.
namespace vectrix::validation {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<double, 9>;

/// A torque constant in body axes, for start <= t < stop. Overlapping pulses add up.
struct SimbodyPulse {
  double start_s;
  double stop_s;
  Vector3 torque_b_nm;
};

/// The state of the centre of mass at the first sample time, about a point mass at the inertial origin.
struct SimbodyOrbit {
  double mu_m3_s2;
  Vector3 r_i_m;
  Vector3 v_i_m_s;
};

/// A free rigid body at the first sample time. Without an orbit its centre of mass is at rest at the origin.
struct SimbodyBody {
  double mass_kg;
  Matrix3
      inertia_tensor_b;  ///< kg m^2, about the centre of mass: entries of the matrix, not products of inertia
  Matrix3 R_i_from_b;    ///< r^i = R_b^i r^b
  Vector3 w_ib_b;        ///< rad/s, body relative to inertial, body axes
  std::optional<SimbodyOrbit> orbit;
  std::vector<SimbodyPulse> pulses;
  bool gravity_gradient = false;  ///< adds tau = 3 mu / |r|^5 r x J r; needs an orbit
};

struct SimbodySample {
  double t_s;
  Matrix3 R_i_from_b;
  Vector3 w_ib_b;
  Vector3 r_i_m;
  Vector3 v_i_m_s;
};

/// Merson (order 4) is more accurate for the same tolerance, Feldberg (order 5) is cheaper. Simbody's CPodes
/// is not used: its Adams method stalls on a free body at tight tolerances, and its BDF is not more accurate
/// than these two.
enum class SimbodyIntegrator { runge_kutta_merson, runge_kutta_feldberg };

struct SimbodyRun {
  std::vector<SimbodySample> samples;
  long steps;
  long rhs_evaluations;
};

/// The motion of `body` at `times_s` (strictly increasing; the first is the time of the initial state).
///
/// `accuracy` bounds Simbody's estimate of the local error of one step, in units of the motion itself (see
/// the .cpp). The error at the end is larger; it decreases with a tighter accuracy. Steps end at every sample
/// time and at both ends of every pulse: nothing is interpolated, and no step contains a jump of the torque.
/// Throws std::invalid_argument for bad data, and Simbody's own exception (a std::exception) if a step fails.
SimbodyRun simbody_propagate(const SimbodyBody& body, double accuracy, const std::vector<double>& times_s,
                             SimbodyIntegrator integrator);

}  // namespace vectrix::validation
