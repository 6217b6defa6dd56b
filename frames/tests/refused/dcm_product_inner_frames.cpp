// mistake: two rotations whose inner frames do not cancel
// expect: Left = (vectrix::)?Dcm<Camera, Body
// expect: Right = (vectrix::)?Dcm<Gcrf, Body
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  return R_camera_from_body * inverse(R_gcrf_from_body);
#else
  return R_camera_from_body * R_gcrf_from_body;
#endif
}
