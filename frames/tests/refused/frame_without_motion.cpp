// mistake: a frame that is neither inertial nor moving
// expect: Camera
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

struct Camera {};
struct MovingCamera : vectrix::moving_frame {};

auto mounting() {
#ifdef REPAIRED
  return aligned(to<MovingCamera>, from<Body>);
#else
  return aligned(to<Camera>, from<Body>);
#endif
}
