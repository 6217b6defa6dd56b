// mistake: two screws added, as twists are
// expect: Left = (vectrix::)?Screw<Gcrf, Body
// expect: Right = (vectrix::)?Screw<Body, Camera
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

Transform<Gcrf, Camera> place(const Screw<Gcrf, Body>& xi_ab, const Screw<Body, Camera>& xi_bc) {
#ifdef REPAIRED
  return exp(xi_ab) * exp(xi_bc);
#else
  return exp(xi_ab + xi_bc);
#endif
}
