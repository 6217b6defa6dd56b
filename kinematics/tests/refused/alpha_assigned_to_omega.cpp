// mistake: an angular acceleration assigned to an angular velocity
// expect: AngularAcceleration<Gcrf, Body
// expect: AngularVelocity<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

AngularVelocity<Gcrf, Body, In<Body>> rate(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_body,
                                           Quantity<si::time> dt) {
#ifdef REPAIRED
  return angular_velocity(of<Body>, relative_to<Gcrf>, alpha_body.vector() * dt);
#else
  static_cast<void>(dt);
  return alpha_body;
#endif
}
