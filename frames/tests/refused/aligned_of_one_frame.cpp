// mistake: the axes of a frame, claimed to be parallel to themselves
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Body, Gcrf> start() {
#ifdef REPAIRED
  return aligned(to<Body>, from<Gcrf>);
#else
  return aligned(to<Body>, from<Body>);
#endif
}
