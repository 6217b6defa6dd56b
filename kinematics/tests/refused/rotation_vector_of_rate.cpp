// mistake: a rate given for a rotation vector
// expect: UnitGiven = (vectrix::)?si::angular_velocity
// expect: an angle
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const Vector<Body, si::angular_velocity>& w_body, Quantity<si::time> dt) {
#ifdef REPAIRED
  return rotation_vector(of<Body>, relative_to<Gcrf>, w_body * dt);
#else
  static_cast<void>(dt);
  return rotation_vector(of<Body>, relative_to<Gcrf>, w_body);
#endif
}
