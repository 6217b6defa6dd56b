// mistake: the gravity-gradient torque, about the centre of mass, with the inertia about a hinge
// expect: InertiaAbout = Hinge
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto gradient(const Quantity<si::gravitational_parameter>& mu, const Inertia<Body, Hinge>& J_hinge,
              const Inertia<Body>& J_body, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return static_cast<void>(J_hinge), gravity_gradient_torque(mu, J_body, r_body);
#else
  return static_cast<void>(J_body), gravity_gradient_torque(mu, J_hinge, r_body);
#endif
}
