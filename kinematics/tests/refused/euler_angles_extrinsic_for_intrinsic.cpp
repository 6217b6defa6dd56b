// mistake: angles about the axes of a, which stay, used as angles about axes that turn along
// expect: Extrinsic<3, 2, 1>
// expect: Intrinsic<3, 2, 1>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body> attitude(const EulerAngles<Extrinsic<3, 2, 1>, Gcrf, Body>& x) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, dcm(x));
#else
  return x;
#endif
}
