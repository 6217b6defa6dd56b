// mistake: the gravity-gradient torque in the body's axes with a position in inertial ones
// expect: PositionIn = Gcrf
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto gradient(const Quantity<si::gravitational_parameter>& mu, const Inertia<Body>& J_body,
              const Vector<Gcrf, si::length>& r_gcrf, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return gravity_gradient_torque(mu, J_body, R_body_from_gcrf * r_gcrf);
#else
  static_cast<void>(R_body_from_gcrf);
  return gravity_gradient_torque(mu, J_body, r_gcrf);
#endif
}
