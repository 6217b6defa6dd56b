// mistake: the derivative of a position transported with a velocity in the place of the position
// expect: Derivative<Body, Body, (vectrix::)?si::length
// expect: Vector<Body, (vectrix::)?si::velocity
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto velocity(const Derivative<Body, Body, si::length>& rdot, const Vector<Body, si::length>& r_body,
              const Vector<Body, si::velocity>& v_body, const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  static_cast<void>(v_body);
  return transport(observed_from<Gcrf>, rdot, r_body, w_body);
#else
  static_cast<void>(r_body);
  return transport(observed_from<Gcrf>, rdot, v_body, w_body);
#endif
}
