// mistake: a rotation joined with the rate of another pair of frames
// expect: DcmFrom = Body
// expect: RateOf = Camera
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const Dcm<Gcrf, Body>& R_gcrf_from_body,
            const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera_body,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera_body);
  return moving_dcm(R_gcrf_from_body, w_gcrf_body_body);
#else
  static_cast<void>(w_gcrf_body_body);
  return moving_dcm(R_gcrf_from_body, w_gcrf_camera_body);
#endif
}
