// mistake: two rates expressed in different frames added
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Camera>
// expect: one frame and one unit
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto rate(const Dcm<Camera, Body>& R_camera_from_body,
          const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body_body,
          const AngularVelocity<Body, Camera, In<Camera>>& w_body_camera_camera) {
#ifdef REPAIRED
  return R_camera_from_body * w_gcrf_body_body + w_body_camera_camera;
#else
  static_cast<void>(R_camera_from_body);
  return w_gcrf_body_body + w_body_camera_camera;
#endif
}
