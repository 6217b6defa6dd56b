// mistake: angles in degrees
// expect: Sequence = (vectrix::)?Intrinsic<3, 2, 1>
// expect: two frames; angles in rad
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(double yaw, double pitch, double roll) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Gcrf>, convert<si::angle>(yaw * si::degree),
                      convert<si::angle>(pitch * si::degree), convert<si::angle>(roll * si::degree));
#else
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Gcrf>, yaw * si::degree, pitch * si::degree,
                      roll * si::degree);
#endif
}
