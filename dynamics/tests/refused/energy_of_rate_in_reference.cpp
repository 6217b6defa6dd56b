// mistake: the kinetic energy of an inertia in the body's axes with a rate in the reference's
// expect: kinetic_energy
// expect: Gcrf
// expect: Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto energy(const Inertia<Body>& J_body, const Dcm<Body, Gcrf>& R_body_from_gcrf,
            const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf) {
#ifdef REPAIRED
  return kinetic_energy(J_body, R_body_from_gcrf * w_gcrf);
#else
  static_cast<void>(R_body_from_gcrf);
  return kinetic_energy(J_body, w_gcrf);
#endif
}
