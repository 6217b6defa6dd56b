// mistake: two quaternions whose inner frames do not cancel
// expect: Left = (vectrix::)?Quaternion<Camera, Body
// expect: Right = (vectrix::)?Quaternion<Gcrf, Body
// expect: the inner frames cancel
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Quaternion<Camera, Body>& q_camera_from_body,
              const Quaternion<Gcrf, Body>& q_gcrf_from_body) {
#ifdef REPAIRED
  return q_camera_from_body * inverse(q_gcrf_from_body);
#else
  return q_camera_from_body * q_gcrf_from_body;
#endif
}
