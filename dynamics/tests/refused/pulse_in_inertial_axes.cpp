// mistake: a pulse constant in the body's axes, given in inertial ones
// expect: Vector<Gcrf, (vectrix::)?si::torque
// expect: Vector<Body, (vectrix::)?si::torque
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto thruster(const Vector<Gcrf, si::torque>& torque_gcrf, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return PulseTorque<Body>{0.0 * si::second, 1.0 * si::second, R_body_from_gcrf * torque_gcrf};
#else
  static_cast<void>(R_body_from_gcrf);
  return PulseTorque<Body>{0.0 * si::second, 1.0 * si::second, torque_gcrf};
#endif
}
