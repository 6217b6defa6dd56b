// mistake: a rate, which knows its two frames, assigned to a vector, which does not
// expect: AngularVelocity<Gcrf, Body
// expect: Vector<Body, (vectrix::)?si::angular_velocity
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

Vector<Body, si::angular_velocity> rate(const AngularVelocity<Gcrf, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return w_body.vector();
#else
  return w_body;
#endif
}
