// mistake: a torque given for a rate
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::torque
// expect: a vector in rad/s
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate(const Vector<Body, si::torque>& tau_body, const Vector<Body, si::angular_velocity>& w_body) {
#ifdef REPAIRED
  static_cast<void>(tau_body);
  return angular_velocity(of<Body>, relative_to<Gcrf>, w_body);
#else
  static_cast<void>(w_body);
  return angular_velocity(of<Body>, relative_to<Gcrf>, tau_body);
#endif
}
