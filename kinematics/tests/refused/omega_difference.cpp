// mistake: the difference of two rates, where the reversal of one says which
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: w_ab_c . -w_db_c
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto rate(const AngularVelocity<Gcrf, Camera, In<Body>>& w_gcrf_camera,
          const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  return -w_gcrf_body + w_gcrf_camera;
#else
  return w_gcrf_camera - w_gcrf_body;
#endif
}
