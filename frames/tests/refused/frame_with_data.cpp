// mistake: a frame that is not an empty type
// expect: Camera
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

template <class Data> struct Camera : vectrix::moving_frame { Data focal_length; };
template <> struct Camera<void> : vectrix::moving_frame {};

auto mounting() {
#ifdef REPAIRED
  return aligned(to<Camera<void>>, from<Body>);
#else
  return aligned(to<Camera<int>>, from<Body>);
#endif
}
