// mistake: the negative of a quaternion, which is the same rotation
// expect: Quaternion<Body, Gcrf
// expect: the same rotation
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto reverse(const Quaternion<Body, Gcrf>& q_body_from_gcrf) {
#ifdef REPAIRED
  return inverse(q_body_from_gcrf);
#else
  return -q_body_from_gcrf;
#endif
}
