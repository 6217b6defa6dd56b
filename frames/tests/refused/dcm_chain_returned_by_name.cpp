// mistake: a named product of rotations returned without its type
// expect: DcmChain<Camera, Gcrf|ToFrame = Camera; FromFrame = Gcrf
// expect: give the product a type
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  const Dcm<Camera, Gcrf> R_camera_from_gcrf = R_camera_from_body * R_body_from_gcrf;
#else
  auto R_camera_from_gcrf = R_camera_from_body * R_body_from_gcrf;
#endif
  return R_camera_from_gcrf;
}
