// mistake: a rotation vector, in radians, given for modified Rodrigues parameters
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::angle
// expect: numbers without unit
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Vector<Body, si::angle>& theta) {
#ifdef REPAIRED
  return modified_rodrigues(exp_quaternion(rotation_vector(of<Body>, relative_to<Gcrf>, theta)));
#else
  return modified_rodrigues(of<Body>, relative_to<Gcrf>, theta);
#endif
}
