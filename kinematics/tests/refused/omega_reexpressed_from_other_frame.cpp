// mistake: a rate re-expressed by a rotation from a frame in which it is not expressed
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: the inner frames cancel
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
