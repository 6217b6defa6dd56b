// mistake: 3-1-3 angles used as 3-2-1
// expect: Intrinsic<3, 1, 3>
// expect: Intrinsic<3, 2, 1>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body> attitude(const EulerAngles<Intrinsic<3, 1, 3>, Gcrf, Body>& x) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, dcm(x));
#else
  return x;
#endif
}
