// mistake: inertias expressed in different frames joined
// expect: Inertia<Body, Hinge
// expect: Inertia<Wheel, Hinge
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Satellite : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto satellite(const Inertia<Body, Hinge>& J_body, const Inertia<Wheel, Hinge>& J_wheel,
               const Dcm<Body, Wheel>& R_body_from_wheel) {
#ifdef REPAIRED
  return join(of<Satellite>, J_body, R_body_from_wheel * J_wheel);
#else
  return static_cast<void>(R_body_from_wheel), join(of<Satellite>, J_body, J_wheel);
#endif
}
