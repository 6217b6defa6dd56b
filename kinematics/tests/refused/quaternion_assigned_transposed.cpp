// mistake: q_a_from_b assigned to a variable of type q_b_from_a
// expect: Quaternion<Gcrf, Body
// expect: Quaternion<Body, Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Quaternion<Body, Gcrf> attitude(const Quaternion<Gcrf, Body>& q_gcrf_from_body) {
#ifdef REPAIRED
  return inverse(q_gcrf_from_body);
#else
  return q_gcrf_from_body;
#endif
}
