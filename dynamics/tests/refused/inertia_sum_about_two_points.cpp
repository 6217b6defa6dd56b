// mistake: inertias about different points joined: each about its own centre of mass
// expect: Inertia<Body
// expect: Inertia<Wheel
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Satellite : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto satellite(const Inertia<Body, Hinge>& J_body,
               const Inertia<Wheel, CentreOfMassOf<Wheel>, In<Body>>& J_wheel,
               const Displacement<CentreOfMassOf<Wheel>, Hinge, In<Body>>& r_wh,
               const Quantity<si::mass>& m) {
#ifdef REPAIRED
  return join(of<Satellite>, J_body, shift(J_wheel, r_wh, m));
#else
  return static_cast<void>(r_wh), static_cast<void>(m), join(of<Satellite>, J_body, J_wheel);
#endif
}
