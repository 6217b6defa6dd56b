// mistake: Euler's equation in the body's axes with a torque in inertial ones
// expect: TorqueIn = Gcrf
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Gcrf, Body, In<Body>>& w_body,
                  const Dcm<Body, Gcrf>& R_body_from_gcrf, const Vector<Gcrf, si::torque>& torque_gcrf) {
#ifdef REPAIRED
  return euler(J_body, w_body, R_body_from_gcrf * torque_gcrf);
#else
  static_cast<void>(R_body_from_gcrf);
  return euler(J_body, w_body, torque_gcrf);
#endif
}
