// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(double a, double b, double c, double d) {
#ifdef REPAIRED
  return quaternion_scalar_first(to<Body>, from<Gcrf>, a, b, c, d);
#else
  return quaternion_scalar_first(to<Body>, from<Body>, a, b, c, d);
#endif
}
