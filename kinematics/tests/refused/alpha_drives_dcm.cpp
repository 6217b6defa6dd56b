// mistake: an angular acceleration given for an angular velocity
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                      const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_body,
                      const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  static_cast<void>(alpha_body);
  return rate(R_gcrf_from_body, w_body);
#else
  static_cast<void>(w_body);
  return rate(R_gcrf_from_body, alpha_body);
#endif
}
