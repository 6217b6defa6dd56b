// mistake: a turn of a frame to itself
// expect: OfFrame = Body
// expect: RelativeFrame = Body
// expect: two frames
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const Vector<Body, si::angle>& theta) {
#ifdef REPAIRED
  return rotation_vector(of<Body>, relative_to<Gcrf>, theta);
#else
  return rotation_vector(of<Body>, relative_to<Body>, theta);
#endif
}
