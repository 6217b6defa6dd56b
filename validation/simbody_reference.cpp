#include "simbody_reference.hpp"

#include <Simbody.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

namespace vectrix::validation {
namespace {

using SimTK::Mat33;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Vec3;

constexpr double rotation_tolerance = 1e-12;  // the remaining error is below that of any run
constexpr double inertia_tolerance = 1e-12;   // relative to the trace: rounding of a re-expressed tensor

/// The units in which Simbody integrates. Each is a power of two, so that scaling causes no rounding.
///
/// Simbody's error norm is the larger of two root mean squares. Errors of q (quaternion, position) are
/// absolute, with weight 1 per unit. Errors of u (angular, linear velocity) are absolute below 1 and relative
/// above. In SI units a low orbit then requires an accuracy of 1e-10 m in 7e6 m (below rounding: the steps
/// become very short), while angular rates of 1e-3 rad/s are controlled to 1e-10 rad/s only. Here the unit of
/// length is the radius of the orbit, the unit of time is the inverse of the fastest rate, and J is of order
/// 1. Then all seven q and six u are of order 1 at most. The weights of Simbody's State (updUWeights) cannot
/// do this: one weight is used for both an angle and its rate.
struct Units {
  double length_m = 1.0;
  double time_s = 1.0;
  double inertia_kg_m2 = 1.0;

  double mass_kg() const { return inertia_kg_m2 / (length_m * length_m); }
  double torque_nm() const { return inertia_kg_m2 / (time_s * time_s); }
  double velocity_m_s() const { return length_m / time_s; }
  double mu_m3_s2() const { return length_m * velocity_m_s() * velocity_m_s(); }
};

[[noreturn]] void refuse(const std::string& operand_and_fault, double number) {
  std::ostringstream text;
  text.precision(17);
  text << "simbody_propagate: " << operand_and_fault << ": " << number;
  throw std::invalid_argument(text.str());
}

void require_finite(const std::string& operand, const double* first, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!std::isfinite(first[i])) refuse(operand + "[" + std::to_string(i) + "] is not finite", first[i]);
}

Vec3 to_simbody(const Vector3& v) {
  return {v[0], v[1], v[2]};
}
Mat33 to_simbody(const Matrix3& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}
Vector3 to_plain(const Vec3& v) {
  return {v[0], v[1], v[2]};
}
Matrix3 to_plain(const Mat33& m) {
  return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

void check_rotation(const Matrix3& R) {
  require_finite("R_i_from_b", R.data(), R.size());
  const Mat33 M = to_simbody(R);
  const double distance = (M * ~M - Mat33(1, 0, 0, 0, 1, 0, 0, 0, 1)).norm();
  if (distance > rotation_tolerance) refuse("R_i_from_b is not orthogonal, |R R^T - 1|", distance);
  if (SimTK::det(M) < 0) refuse("R_i_from_b is not a rotation, its determinant", SimTK::det(M));
}

double least_leading_minor(const Mat33& M) {
  return std::min({M[0][0], M[0][0] * M[1][1] - M[0][1] * M[1][0], SimTK::det(M)});
}

/// J and the matrix of second moments, 1/2 tr(J) 1 - J, must be those of a body: symmetric and not negative.
void check_inertia(const Matrix3& tensor) {
  require_finite("inertia_tensor_b", tensor.data(), tensor.size());
  const double trace = tensor[0] + tensor[4] + tensor[8];
  if (!(trace > 0)) refuse("inertia_tensor_b has no positive trace, kg m^2", trace);
  const Mat33 J = to_simbody(tensor) / trace;
  const double asymmetry = (J - ~J).norm();
  if (asymmetry > inertia_tolerance) refuse("inertia_tensor_b is not symmetric, |J - J^T| / tr J", asymmetry);
  if (!(least_leading_minor(J) > 0))
    refuse("inertia_tensor_b is not positive definite, least minor of J / tr J", least_leading_minor(J));
  const double half = 0.5 + inertia_tolerance;
  const double least = least_leading_minor(Mat33(half, 0, 0, 0, half, 0, 0, 0, half) - J);
  if (!(least > 0))
    refuse("inertia_tensor_b breaks the triangle inequality, least minor of 1/2 - J / tr J", least);
}

void check(const SimbodyBody& body, double accuracy, const std::vector<double>& times_s) {
  if (!std::isfinite(body.mass_kg) || !(body.mass_kg > 0)) refuse("mass_kg is not positive", body.mass_kg);
  check_inertia(body.inertia_tensor_b);
  check_rotation(body.R_i_from_b);
  require_finite("w_ib_b", body.w_ib_b.data(), body.w_ib_b.size());
  if (body.orbit) {
    const auto& [mu, r, v] = *body.orbit;
    if (!std::isfinite(mu) || !(mu > 0)) refuse("mu_m3_s2 is not positive", mu);
    require_finite("r_i_m", r.data(), r.size());
    require_finite("v_i_m_s", v.data(), v.size());
    if (!(to_simbody(r).norm() > 0)) refuse("r_i_m is at the attracting centre, |r|", 0.0);
  }
  if (body.gravity_gradient && !body.orbit) refuse("gravity_gradient without an orbit, orbits given", 0.0);
  for (const auto& pulse : body.pulses) {
    if (!(pulse.start_s < pulse.stop_s) || !std::isfinite(pulse.stop_s - pulse.start_s))
      refuse("a pulse does not stop after it starts, stop - start", pulse.stop_s - pulse.start_s);
    require_finite("torque_b_nm", pulse.torque_b_nm.data(), pulse.torque_b_nm.size());
  }
  if (!(accuracy > 0) || !(accuracy < 1)) refuse("accuracy is not between 0 and 1", accuracy);
  if (times_s.empty()) refuse("times_s is empty, its size", 0.0);
  require_finite("times_s", times_s.data(), times_s.size());
  for (std::size_t i = 1; i < times_s.size(); ++i)
    if (!(times_s[i - 1] < times_s[i])) refuse("times_s does not increase at", times_s[i]);
}

double power_of_two_near(double x) {
  return std::exp2(std::round(std::log2(x)));
}

Units units_of_motion(const SimbodyBody& body, const std::vector<double>& times_s) {
  const auto& J = body.inertia_tensor_b;
  Units units;
  units.inertia_kg_m2 = power_of_two_near(J[0] + J[4] + J[8]);
  double fastest_rad_s = to_simbody(body.w_ib_b).norm();
  if (body.orbit) {
    const double r = to_simbody(body.orbit->r_i_m).norm();
    units.length_m = power_of_two_near(r);
    fastest_rad_s = std::max(fastest_rad_s, std::sqrt(body.orbit->mu_m3_s2 / r) / r);
  }
  for (const auto& pulse : body.pulses) {  // the rate that a pulse gives a ball of this size
    const double duration_s =
        std::min(pulse.stop_s, times_s.back()) - std::max(pulse.start_s, times_s.front());
    const double impulse_nms = to_simbody(pulse.torque_b_nm).norm() * std::max(duration_s, 0.0);
    fastest_rad_s = std::max(fastest_rad_s, impulse_nms / units.inertia_kg_m2);
  }
  if (fastest_rad_s > 0) units.time_s = power_of_two_near(1.0 / fastest_rad_s);
  return units;
}

/// Sum of the pulses that act just after t, in body axes.
Vec3 pulse_torque_b(const SimbodyBody& body, double t_s) {
  Vec3 torque_b(0);
  for (const auto& pulse : body.pulses)
    if (pulse.start_s <= t_s && t_s < pulse.stop_s) torque_b += to_simbody(pulse.torque_b_nm);
  return torque_b;
}

/// -mu m r / |r|^3 at the centre of mass and, if asked, tau^i = 3 mu / |r|^5 r^i x (J^i r^i).
class CentralGravity : public SimTK::Force::Custom::Implementation {
 public:
  CentralGravity(const SimTK::MobilizedBody& body, double mu, bool gradient)
      : body_(body), mu_(mu), gradient_(gradient) {}

  void calcForce(const State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces_i, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    const Vec3 r_i = body_.getBodyOriginLocation(state);
    const double r = r_i.norm();
    const Vec3 force_i = -mu_ * body_.getBodyMass(state) / (r * r * r) * r_i;
    Vec3 torque_i(0);
    if (gradient_) {
      const SimTK::Inertia J_i = body_.getBodySpatialInertiaInGround(state).calcInertia();
      torque_i = 3.0 * mu_ / std::pow(r, 5) * (r_i % (J_i * r_i));
    }
    body_.applyBodyForce(state, SimTK::SpatialVec(torque_i, force_i), body_forces_i);
  }

  SimTK::Real calcPotentialEnergy(const State& state) const override {  // of the force only
    return -mu_ * body_.getBodyMass(state) / body_.getBodyOriginLocation(state).norm();
  }

 private:
  SimTK::MobilizedBody body_;
  double mu_;
  bool gradient_;
};

/// A torque constant in body axes, tau^i = R_b^i tau^b. The owner changes tau^b between two continuous
/// intervals.
class BodyTorque : public SimTK::Force::Custom::Implementation {
 public:
  BodyTorque(const SimTK::MobilizedBody& body, const Vec3& torque_b) : body_(body), torque_b_(torque_b) {}

  void calcForce(const State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces_i, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    body_.applyBodyTorque(state, body_.getBodyRotation(state) * torque_b_, body_forces_i);
  }

  SimTK::Real calcPotentialEnergy(const State&) const override { return 0.0; }

 private:
  SimTK::MobilizedBody body_;
  const Vec3& torque_b_;
};

std::unique_ptr<SimTK::Integrator> make_integrator(SimbodyIntegrator kind, const SimTK::System& system) {
  switch (kind) {
    case SimbodyIntegrator::runge_kutta_merson:
      return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
    case SimbodyIntegrator::runge_kutta_feldberg:
      return std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system);
  }
  refuse("integrator is none of SimbodyIntegrator", static_cast<double>(kind));
}

SimbodySample sample(const SimTK::MobilizedBody& body, const State& state, double t_s, const Units& units) {
  const Rotation R_i_from_b = body.getBodyRotation(state);
  // Simbody gives w_ib in ground axes, that is inertial axes: w_ib^b = (R_b^i)^T w_ib^i.
  const Vec3 w_ib_b = ~R_i_from_b * body.getBodyAngularVelocity(state) / units.time_s;
  return {t_s, to_plain(R_i_from_b.asMat33()), to_plain(w_ib_b),
          to_plain(body.getBodyOriginLocation(state) * units.length_m),
          to_plain(body.getBodyOriginVelocity(state) * units.velocity_m_s())};
}

/// The sample times and the ends of the pulses between the first and the last of them; sorted, without
/// duplicates.
std::vector<double> ends_of_steps(const SimbodyBody& body, const std::vector<double>& times_s) {
  std::vector<double> ends = times_s;
  for (const auto& pulse : body.pulses)
    for (const double t : {pulse.start_s, pulse.stop_s})
      if (times_s.front() < t && t < times_s.back()) ends.push_back(t);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

}  // namespace

SimbodyRun simbody_propagate(const SimbodyBody& body, double accuracy, const std::vector<double>& times_s,
                             SimbodyIntegrator kind) {
  check(body, accuracy, times_s);
  const Units units = units_of_motion(body, times_s);

  // One system for each call, because threads must not share a Simbody system.
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  matter.setShowDefaultGeometry(false);

  // Simbody's Inertia takes moments (xx, yy, zz) and the off-diagonal entries of the tensor (xy, xz, yz).
  const Matrix3& J = body.inertia_tensor_b;
  const SimTK::Inertia J_b(Vec3(J[0], J[4], J[8]) / units.inertia_kg_m2,
                           Vec3(J[1], J[2], J[5]) / units.inertia_kg_m2);
  const SimTK::Body::Rigid rigid(SimTK::MassProperties(body.mass_kg / units.mass_kg(), Vec3(0), J_b));
  SimTK::MobilizedBody::Free free(matter.Ground(), rigid);

  Vec3 torque_b = pulse_torque_b(body, times_s.front()) / units.torque_nm();
  SimTK::Force::Custom(forces, new BodyTorque(free, torque_b));
  if (body.orbit)
    SimTK::Force::Custom(
        forces, new CentralGravity(free, body.orbit->mu_m3_s2 / units.mu_m3_s2(), body.gravity_gradient));

  State state = system.realizeTopology();
  matter.setUseEulerAngles(state, false);
  system.realizeModel(state);
  const Rotation R_i_from_b(to_simbody(body.R_i_from_b), true);  // checked above, so not corrected here
  free.setQToFitRotation(state, R_i_from_b);
  // The speeds of a Free mobilizer are in its parent's axes: w_ib^i = R_b^i w_ib^b.
  free.setUToFitAngularVelocity(state, R_i_from_b * to_simbody(body.w_ib_b) * units.time_s);
  if (body.orbit) {
    free.setQToFitTranslation(state, to_simbody(body.orbit->r_i_m) / units.length_m);
    free.setUToFitLinearVelocity(state, to_simbody(body.orbit->v_i_m_s) / units.velocity_m_s());
  }
  state.setTime(times_s.front() / units.time_s);

  const auto integrator = make_integrator(kind, system);
  integrator->setAccuracy(accuracy);
  integrator->initialize(state);

  SimbodyRun run{};
  const auto take_sample = [&](double t_s) {
    system.realize(integrator->getState(), SimTK::Stage::Velocity);
    run.samples.push_back(sample(free, integrator->getState(), t_s, units));
  };
  const auto count_work = [&] {
    run.steps += integrator->getNumStepsTaken();
    run.rhs_evaluations += integrator->getNumRealizations();
  };
  take_sample(times_s.front());
  std::size_t next_sample = 1;
  for (const double t_s : ends_of_steps(body, times_s)) {
    const double t = t_s / units.time_s;
    while (integrator->getTime() < t) integrator->stepTo(t, t);
    if (next_sample < times_s.size() && t_s == times_s[next_sample]) {
      take_sample(t_s);
      ++next_sample;
    }
    const Vec3 torque_from_now_b = pulse_torque_b(body, t_s) / units.torque_nm();
    if (torque_from_now_b != torque_b) {
      torque_b = torque_from_now_b;
      count_work();
      state = integrator->getState();  // the copy does not keep results computed with the old torque
      integrator->resetAllStatistics();
      integrator->initialize(state);
    }
  }
  count_work();
  return run;
}

}  // namespace vectrix::validation
