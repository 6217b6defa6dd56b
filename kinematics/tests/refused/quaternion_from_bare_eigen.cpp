// mistake: a bare quaternion that nobody has claimed to be a rotation
// expect: Quaternion<Body, Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Quaternion<Body, Gcrf> attitude(const Eigen::Quaterniond& q) {
#ifdef REPAIRED
  return quaternion_scalar_first(to<Body>, from<Gcrf>, q.w(), q.x(), q.y(), q.z());
#else
  return q;
#endif
}
