// mistake: the gravity-gradient torque in the body's axes with a position in inertial ones
// expect: PositionIn = Eci
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto gradient(const Quantity<si::gravitational_parameter>& mu, const Inertia<Body>& J_body,
              const Vector<Eci, si::length>& r_eci, const Dcm<Body, Eci>& R_body_from_eci) {
#ifdef REPAIRED
  return gravity_gradient_torque(mu, J_body, R_body_from_eci * r_eci);
#else
  static_cast<void>(R_body_from_eci);
  return gravity_gradient_torque(mu, J_body, r_eci);
#endif
}
