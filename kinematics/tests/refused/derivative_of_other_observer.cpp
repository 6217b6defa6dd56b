// mistake: the derivative seen from b used as the one seen from a
// expect: Derivative<Body, Body
// expect: Derivative<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Derivative<Gcrf, Body, si::length> velocity(const Derivative<Body, Body, si::length>& rdot,
                                            const Vector<Body, si::length>& r_body,
                                            const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, rdot, r_body, w_body);
#else
  static_cast<void>(r_body);
  static_cast<void>(w_body);
  return rdot;
#endif
}
