// mistake: the two rotations of a chain in the wrong order
// expect: Left = (vectrix::)?Dcm<Body, Gcrf
// expect: Right = (vectrix::)?Dcm<Camera, Body
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return R_camera_from_body * R_body_from_gcrf;
#else
  return R_body_from_gcrf * R_camera_from_body;
#endif
}
