// mistake: nine numbers that nobody has claimed to be a rotation
// expect: Dcm<Body, Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Body, Gcrf> attitude(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return dcm(to<Body>, from<Gcrf>, matrix);
#else
  return matrix;
#endif
}
