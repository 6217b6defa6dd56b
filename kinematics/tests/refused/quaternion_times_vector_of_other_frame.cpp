// mistake: a quaternion applied to a vector that is not expressed in its inner frame
// expect: Left = (vectrix::)?Quaternion<Body, Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: the inner frames cancel
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto position(const Quaternion<Body, Gcrf>& q_body_from_gcrf, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return inverse(q_body_from_gcrf) * r_body;
#else
  return q_body_from_gcrf * r_body;
#endif
}
