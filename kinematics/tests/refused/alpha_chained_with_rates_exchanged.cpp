// mistake: the two rates of a chain of accelerations exchanged: the transport term would change its sign
// expect: RateAb = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Body>
// expect: RateBd = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: one frame c
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
  return chain(alpha_gcrf_body, alpha_body_camera, w_body_camera, w_gcrf_body);
#endif
}
