// mistake: a DCM driven by the rate of a relative to b
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Body, Gcrf, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                      const AngularVelocity<Body, Gcrf, In<Body>>& w_body_gcrf) {
#ifdef REPAIRED
  return rate(R_gcrf_from_body, -w_body_gcrf);
#else
  return rate(R_gcrf_from_body, w_body_gcrf);
#endif
}
