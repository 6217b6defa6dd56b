// mistake: an attitude advanced by the increment of another body
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Before<Gcrf, Camera>, Camera
// expect: of the same b relative to the same a
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto step(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Increment<Gcrf, Camera>& theta_camera,
          const Dcm<Gcrf, Camera>& R_gcrf_from_camera) {
#ifdef REPAIRED
  static_cast<void>(R_gcrf_from_body);
  return advance(R_gcrf_from_camera, theta_camera);
#else
  static_cast<void>(R_gcrf_from_camera);
  return advance(R_gcrf_from_body, theta_camera);
#endif
}
