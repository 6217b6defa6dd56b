#include "simbody_reference_scan.hpp"

#include <Simbody.h>

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
  // A pin turns about z of its own frame, which is along the axis.
  const Rotation Z(SimTK::UnitVec3(three(scan.axis_m)), SimTK::ZAxis);
  const Rotation R_h_from_m(by_rows(scan.R_h_from_m), true);
  SimTK::MobilizedBody::Pin mirror(hub, Transform(R_h_from_m * Z, three(scan.r_hm_h)), rigid(scan.mirror),
                                   Transform(Z));
  SimTK::Motion::Sinusoid(mirror, SimTK::Motion::Position, scan.amplitude, scan.rate, scan.phase);

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
  }
  steps = integrator.getNumStepsTaken();
  return samples;
}

}  // namespace vectrix::validation
