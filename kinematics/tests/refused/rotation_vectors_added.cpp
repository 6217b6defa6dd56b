// mistake: two rotation vectors added, as if turns commuted
// expect: Left = (vectrix::)?RotationVector<Gcrf, Body
// expect: Right = (vectrix::)?RotationVector<Body, Camera
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Gcrf, Camera> attitude(const RotationVector<Gcrf, Body>& theta_ab,
                           const RotationVector<Body, Camera>& theta_bc) {
#ifdef REPAIRED
  return exp(theta_ab) * exp(theta_bc);
#else
  return exp(theta_ab + theta_bc);
#endif
}
