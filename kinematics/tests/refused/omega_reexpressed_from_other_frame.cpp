// mistake: a rate re-expressed by a rotation from a frame in which it is not expressed
// expect: DcmFrom = Body
// expect: RateIn = Gcrf
// expect: w must be expressed in c
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate(const Dcm<Gcrf, Body>& R_gcrf_from_body,
          const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf_body_gcrf) {
#ifdef REPAIRED
  return inverse(R_gcrf_from_body) * w_gcrf_body_gcrf;
#else
  return R_gcrf_from_body * w_gcrf_body_gcrf;
#endif
}
