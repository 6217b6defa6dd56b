// mistake: an acceleration expressed in a where accelerating_dcm() takes it in b
// expect: 'Body' (vs.|and) 'Gcrf'
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const Dcm<Gcrf, Body>& R_gcrf_from_body, const AngularVelocity<Gcrf, Body, In<Body>>& w_body,
            const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_gcrf) {
#ifdef REPAIRED
  return accelerating_dcm(R_gcrf_from_body, w_body, inverse(R_gcrf_from_body) * alpha_gcrf);
#else
  return accelerating_dcm(R_gcrf_from_body, w_body, alpha_gcrf);
#endif
}
