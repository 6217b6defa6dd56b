// mistake: the kinetic energy of an inertia in the body's axes with a rate in the reference's
// expect: kinetic_energy
// expect: Eci
// expect: Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto energy(const Inertia<Body>& J_body, const Dcm<Body, Eci>& R_body_from_eci,
            const AngularVelocity<Eci, Body, In<Eci>>& w_eci) {
#ifdef REPAIRED
  return kinetic_energy(J_body, R_body_from_eci * w_eci);
#else
  static_cast<void>(R_body_from_eci);
  return kinetic_energy(J_body, w_eci);
#endif
}
