// mistake: an acceleration re-expressed by a rotation from a frame in which it is not expressed
// expect: DcmFrom = Body
// expect: AccelerationIn = Gcrf
// expect: alpha must be expressed in c
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
