// mistake: a quaternion where a DCM is needed
// expect: Quaternion<Body, Gcrf
// expect: Dcm<Body, Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Body, Gcrf> attitude(const Quaternion<Body, Gcrf>& q_body_from_gcrf) {
#ifdef REPAIRED
  return dcm(q_body_from_gcrf);
#else
  return q_body_from_gcrf;
#endif
}
