// mistake: Euler's equation in the body's axes with a torque in inertial ones
// expect: TorqueGiven = (vectrix::)?Vector<Eci
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Dcm<Body, Eci>& R_body_from_eci, const Vector<Eci, si::torque>& torque_eci) {
#ifdef REPAIRED
  return euler(J_body, w_body, R_body_from_eci * torque_eci);
#else
  static_cast<void>(R_body_from_eci);
  return euler(J_body, w_body, torque_eci);
#endif
}
