// mistake: two rates that do not chain
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto rate(const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body,
          const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera) {
#ifdef REPAIRED
  return -w_gcrf_body + w_gcrf_camera;
#else
  return w_gcrf_body + w_gcrf_camera;
#endif
}
