// mistake: to and from exchanged at the door
// expect: from<Gcrf>, to<Body>
// expect: ToFrame = (vectrix::)?From<Gcrf>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return dcm(to<Body>, from<Gcrf>, matrix);
#else
  return dcm(from<Gcrf>, to<Body>, matrix);
#endif
}
