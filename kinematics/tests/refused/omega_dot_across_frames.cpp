// mistake: the power of a torque and a rate that are expressed in two frames
// expect: AngularVelocity<Gcrf, Body, (vectrix::)?In<Body
// expect: Vector<Gcrf, (vectrix::)?si::torque
// expect: in one frame
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto power(const AngularVelocity<Gcrf, Body, In<Body>>& w_body, const Vector<Gcrf, si::torque>& torque_gcrf,
           const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return dot(w_body, R_body_from_gcrf * torque_gcrf);
#else
  return dot(w_body, torque_gcrf);
#endif
}
