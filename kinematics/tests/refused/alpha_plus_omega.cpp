// mistake: an angular acceleration and an angular velocity added
// expect: Left = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Body, Camera, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto sum(const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_gcrf_body,
         const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
         const AngularVelocity<Body, Camera, In<Body>>& w_body_camera) {
#ifdef REPAIRED
  static_cast<void>(alpha_gcrf_body);
  return w_gcrf_body + w_body_camera;
#else
  static_cast<void>(w_gcrf_body);
  return alpha_gcrf_body + w_body_camera;
#endif
}
