// mistake: a derivative and its vector expressed in different frames
// expect: Change = (vectrix::)?Derivative<Body, Body
// expect: Vector<Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto velocity(const Derivative<Body, Body, si::length>& rdot, const Dcm<Body, Gcrf>& R_body_from_gcrf,
              const Vector<Gcrf, si::length>& r_gcrf, const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, rdot, R_body_from_gcrf * r_gcrf, w_body);
#else
  static_cast<void>(R_body_from_gcrf);
  return transport(observed_from<Gcrf>, rdot, r_gcrf, w_body);
#endif
}
