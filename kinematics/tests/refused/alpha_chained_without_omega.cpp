// mistake: accelerations added without the rates: the transport term would be lost
// expect: Left = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularAcceleration<Body, Camera, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_gcrf_body,
                  const AngularAcceleration<Body, Camera, In<Body>>& alpha_body_camera,
                  const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
                  const AngularVelocity<Body, Camera, In<Body>>& w_body_camera) {
#ifdef REPAIRED
  return chain(alpha_gcrf_body, alpha_body_camera, w_gcrf_body, w_body_camera);
#else
  static_cast<void>(w_gcrf_body);
  static_cast<void>(w_body_camera);
  return alpha_gcrf_body + alpha_body_camera;
#endif
}
