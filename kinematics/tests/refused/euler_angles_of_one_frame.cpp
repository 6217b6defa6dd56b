// mistake: the Euler angles of a frame relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(Quantity<si::angle> yaw, Quantity<si::angle> pitch, Quantity<si::angle> roll) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Gcrf>, yaw, pitch, roll);
#else
  return euler_angles(intrinsic<3, 2, 1>, of<Body>, relative_to<Body>, yaw, pitch, roll);
#endif
}
