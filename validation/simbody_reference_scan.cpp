#include "simbody_reference_scan.hpp"

#include <Simbody.h>

#include <optional>

namespace vectrix::validation {
namespace {

using SimTK::Mat33;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::Vec3;

Vec3 three(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}
Mat33 by_rows(const std::array<double, 9>& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}
SimTK::Body::Rigid rigid(const SimbodyScanBody& b) {
  const Vec3 c = three(b.centre_b);
  const Mat33 J = by_rows(b.inertia_c_b) + b.mass_kg * (c.normSqr() * Mat33(1.0) - c * ~c);
  return SimTK::Body::Rigid(SimTK::MassProperties(
      b.mass_kg, c, SimTK::Inertia(SimTK::SymMat33(J(0, 0), J(1, 0), J(1, 1), J(2, 0), J(2, 1), J(2, 2)))));
}

}  // namespace

std::vector<SimbodyScanSample> simbody_scan(const SimbodyScan& scan, double accuracy,
                                            const std::vector<double>& times_s, long& steps) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  matter.setShowDefaultGeometry(false);
  SimTK::MobilizedBody::Free hub(matter.Ground(), rigid(scan.hub));
  using Pin = SimTK::MobilizedBody::Pin;
  // A pin turns about z of its own frame, which is along the axis.
  const auto along = [](const std::array<double, 3>& axis) {
    return Rotation(SimTK::UnitVec3(three(axis)), SimTK::ZAxis);
  };
  const auto drive = [](Pin& pin, SimTK::Motion::Level level, const SimbodySine& sine) {
    SimTK::Motion::Sinusoid(pin, level, sine.amplitude, sine.rate, sine.phase);
  };
  const Rotation Z = along(scan.axis_m), R_h_from_m(by_rows(scan.R_h_from_m), true);
  const SimTK::Body::Rigid ring(SimTK::MassProperties(0.0, Vec3(0.0), SimTK::Inertia(0.0)));
  Pin mirror(hub, Transform(R_h_from_m * Z, three(scan.r_hm_h)), scan.free_axis_m ? ring : rigid(scan.mirror),
             Transform(Z));
  drive(mirror, SimTK::Motion::Position, scan.angle);
  std::optional<Pin> free, wheel;
  if (scan.free_axis_m) {
    const Transform second(along(*scan.free_axis_m));
    free.emplace(mirror, second, rigid(scan.mirror), second);
  }
  if (scan.wheel) {
    const Rotation n = along(scan.wheel->axis_h);
    wheel.emplace(hub, Transform(n, three(scan.wheel->r_hw_h)), rigid(scan.wheel->body), Transform(n));
    drive(*wheel, SimTK::Motion::Velocity, scan.wheel->speed);
  }

  SimTK::State state = system.realizeTopology();
  matter.setUseEulerAngles(state, false);
  system.realizeModel(state);
  hub.setUToFitAngularVelocity(state, three(scan.w_ih_h));
  state.setTime(0.0);
  system.prescribe(state);
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(accuracy);
  integrator.initialize(state);

  std::vector<SimbodyScanSample> samples;
  for (const double t : times_s) {
    while (integrator.getTime() < t) integrator.stepTo(t, t);
    const SimTK::State& now = integrator.getState();
    system.realize(now, SimTK::Stage::Acceleration);
    SimTK::Vector of_motion;
    matter.findMotionForces(now, of_motion);  // tau of M u' + tau = f: what the motion takes
    const Mat33 R = hub.getBodyRotation(now).asMat33();
    const Vec3 w = ~hub.getBodyRotation(now) * hub.getBodyAngularVelocity(now);
    samples.push_back({t,
                       {R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)},
                       {w[0], w[1], w[2]},
                       mirror.getOneQ(now, 0),
                       -of_motion[mirror.getFirstUIndex(now)]});
    if (free) {
      samples.back().free_angle = free->getOneQ(now, 0);
      samples.back().free_rate = free->getOneU(now, 0);
    }
    if (wheel) {
      samples.back().spin = wheel->getOneU(now, 0);
      samples.back().wheel_torque_nm = -of_motion[wheel->getFirstUIndex(now)];
    }
  }
  steps = integrator.getNumStepsTaken();
  return samples;
}

}  // namespace vectrix::validation
