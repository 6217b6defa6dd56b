// mistake: the derivative of a rotation used as a rotation
// expect: DcmRate<Gcrf, Body
// expect: Dcm<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Dcm<Gcrf, Body> attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                         const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  static_cast<void>(rate(R_gcrf_from_body, w_body));
  return R_gcrf_from_body;
#else
  return rate(R_gcrf_from_body, w_body);
#endif
}
