// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return dcm(to<Body>, from<Gcrf>, matrix);
#else
  return dcm(to<Body>, from<Body>, matrix);
#endif
}
