// mistake: Euler's equation with the rate expressed in the inertial frame
// expect: RateIn = Gcrf
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf,
                  const Dcm<Body, Gcrf>& R_body_from_gcrf, const Vector<Body, si::torque>& torque_body) {
#ifdef REPAIRED
  return euler(J_body, R_body_from_gcrf * w_gcrf, torque_body);
#else
  static_cast<void>(R_body_from_gcrf);
  return euler(J_body, w_gcrf, torque_body);
#endif
}
