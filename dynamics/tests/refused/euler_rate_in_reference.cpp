// mistake: Euler's equation with the rate expressed in the inertial frame
// expect: RateIn = Eci
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Eci>>& w_eci,
                  const Dcm<Body, Eci>& R_body_from_eci, const Vector<Body, si::torque>& torque_body) {
#ifdef REPAIRED
  return euler(J_body, R_body_from_eci * w_eci, torque_body);
#else
  static_cast<void>(R_body_from_eci);
  return euler(J_body, w_eci, torque_body);
#endif
}
