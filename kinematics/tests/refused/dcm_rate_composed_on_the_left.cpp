// mistake: a rotation composed after the derivative of another
// expect: Left = (vectrix::)?DcmRate<Gcrf, Body
// expect: Right = (vectrix::)?Dcm<Body, Camera
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const DcmRate<Gcrf, Body>& Rdot_gcrf_from_body, const Dcm<Gcrf, Body>& R_gcrf_from_body,
              const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  static_cast<void>(Rdot_gcrf_from_body);
  return R_gcrf_from_body * R_body_from_camera;
#else
  static_cast<void>(R_gcrf_from_body);
  return Rdot_gcrf_from_body * R_body_from_camera;
#endif
}
