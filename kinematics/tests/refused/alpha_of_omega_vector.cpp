// mistake: a vector in rad/s given for an angular acceleration
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::angular_velocity
// expect: a vector in rad/s
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Vector<Body, si::angular_velocity>& w_body, Quantity<si::time> dt) {
#ifdef REPAIRED
  return angular_acceleration(of<Body>, relative_to<Gcrf>, w_body / dt);
#else
  static_cast<void>(dt);
  return angular_acceleration(of<Body>, relative_to<Gcrf>, w_body);
#endif
}
