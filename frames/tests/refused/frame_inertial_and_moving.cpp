// mistake: a frame that is inertial and moving at once
// expect: Earth
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

struct Earth : vectrix::inertial_frame, vectrix::moving_frame {};
struct MovingEarth : vectrix::moving_frame {};

auto attitude() {
#ifdef REPAIRED
  return aligned(to<Body>, from<MovingEarth>);
#else
  return aligned(to<Body>, from<Earth>);
#endif
}
