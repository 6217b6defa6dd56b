// mistake: the derivative of a rotation composed as a rotation
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?DcmRate<Body, Camera
// expect: the kinds go together
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body, const DcmRate<Body, Camera>& Rdot_body_from_camera,
              const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  static_cast<void>(Rdot_body_from_camera);
  return R_gcrf_from_body * R_body_from_camera;
#else
  static_cast<void>(R_body_from_camera);
  return R_gcrf_from_body * Rdot_body_from_camera;
#endif
}
