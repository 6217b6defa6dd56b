// mistake: the increment of a step composed on the left, as if it were expressed in the reference frame
// expect: Left = (vectrix::)?Dcm<(vectrix::)?Before<Gcrf, Body>, Body
// expect: Right = (vectrix::)?Dcm<Gcrf, (vectrix::)?Before<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Gcrf, Body> step(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Increment<Gcrf, Body>& theta) {
#ifdef REPAIRED
  return before(R_gcrf_from_body) * vectrix::exp(theta);
#else
  return vectrix::exp(theta) * before(R_gcrf_from_body);
#endif
}
