// mistake: a chain whose first two rotations do not meet
// expect: Left = (vectrix::)?Dcm<Camera, Body
// expect: Right = (vectrix::)?Dcm<Gcrf, Body
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

Vector<Camera, si::length> seen(const Dcm<Camera, Body>& R_camera_from_body,
                                const Dcm<Gcrf, Body>& R_gcrf_from_body,
                                const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  return R_camera_from_body * inverse(R_gcrf_from_body) * r_gcrf;
#else
  return R_camera_from_body * R_gcrf_from_body * r_gcrf;
#endif
}
