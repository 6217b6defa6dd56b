// mistake: an acceleration re-expressed by a rotation from a frame in which it is not expressed
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: the inner frames cancel
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                  const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_gcrf) {
#ifdef REPAIRED
  return inverse(R_gcrf_from_body) * alpha_gcrf;
#else
  return R_gcrf_from_body * alpha_gcrf;
#endif
}
