// mistake: a frame not accelerated relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto mounted() {
#ifdef REPAIRED
  return unaccelerated(of<Body>, relative_to<Gcrf>, in<Body>);
#else
  return unaccelerated(of<Body>, relative_to<Body>, in<Body>);
#endif
}
