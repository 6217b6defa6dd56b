// mistake: a quaternion and a DCM multiplied
// expect: Left = (vectrix::)?Quaternion<Camera, Body
// expect: Right = (vectrix::)?Dcm<Body, Gcrf
// expect: the kinds go together
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Quaternion<Camera, Body>& q_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return dcm(q_camera_from_body) * R_body_from_gcrf;
#else
  return q_camera_from_body * R_body_from_gcrf;
#endif
}
