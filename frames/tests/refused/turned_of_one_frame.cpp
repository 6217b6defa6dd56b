// mistake: a frame turned relative to itself
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const Quantity<si::angle>& angle) {
#ifdef REPAIRED
  return turned_z(to<Body>, from<Gcrf>, angle);
#else
  return turned_z(to<Body>, from<Body>, angle);
#endif
}
