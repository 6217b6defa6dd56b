// mistake: a chain of rotations on a vector of a frame in its middle
// expect: Left = (vectrix::)?DcmChain<Camera, Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto sight(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf,
           const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return R_camera_from_body * R_body_from_gcrf * inverse(R_body_from_gcrf) * r_body;
#else
  return R_camera_from_body * R_body_from_gcrf * r_body;
#endif
}
