// mistake: a step in the body's axes with the rate expressed in the reference frame
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Gcrf
// expect: the rate in b's own axes
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto step(const Dcm<Gcrf, Body>& R_gcrf_from_body, const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_gcrf,
          const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return exponential_step(R_gcrf_from_body, inverse(R_gcrf_from_body) * w_gcrf, dt);
#else
  return exponential_step(R_gcrf_from_body, w_gcrf, dt);
#endif
}
