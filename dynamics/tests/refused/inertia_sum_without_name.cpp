// mistake: inertias added, when nothing says of which body the sum is
// expect: Inertia<Body, Hinge
// expect: Inertia<Wheel, Hinge
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Satellite : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto satellite(const Inertia<Body, Hinge>& J_body, const Inertia<Wheel, Hinge, In<Body>>& J_wheel) {
#ifdef REPAIRED
  return join(of<Satellite>, J_body, J_wheel);
#else
  return J_body + J_wheel;
#endif
}
