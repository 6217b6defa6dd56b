// mistake: a slerp between attitudes of different bodies
// expect: FirstFrom = Body; LastTo = Gcrf; LastFrom = Camera|Slerp<Gcrf, Body, Gcrf, Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto slew(const Quaternion<Gcrf, Body>& q0, const Quaternion<Gcrf, Camera>& q1,
          const Dcm<Camera, Body>& R_camera_from_body) {
#ifdef REPAIRED
  return Slerp(0.0 * si::second, q0, 10.0 * si::second, q1 * quaternion(R_camera_from_body));
#else
  static_cast<void>(R_camera_from_body);
  return Slerp(0.0 * si::second, q0, 10.0 * si::second, q1);
#endif
}
