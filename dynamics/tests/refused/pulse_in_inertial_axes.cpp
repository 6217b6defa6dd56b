// mistake: a pulse constant in the body's axes, given in inertial ones
// expect: Vector<Eci
// expect: Vector<Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto thruster(const Vector<Eci, si::torque>& torque_eci, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return PulseTorque<Body>{0.0 * si::second, 1.0 * si::second, R_body_from_eci * torque_eci};
#else
  static_cast<void>(R_body_from_eci);
  return PulseTorque<Body>{0.0 * si::second, 1.0 * si::second, torque_eci};
#endif
}
