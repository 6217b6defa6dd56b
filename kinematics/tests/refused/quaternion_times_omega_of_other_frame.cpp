// mistake: a quaternion re-expresses a rate that is expressed in another frame
// expect: Left = (vectrix::)?Quaternion<Body, Gcrf
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto reexpressed(const Quaternion<Body, Gcrf>& q_body_from_gcrf,
                 const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return inverse(q_body_from_gcrf) * w_body;
#else
  return q_body_from_gcrf * w_body;
#endif
}
