// mistake: a DCM driven by the rate of another pair of frames
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Camera, (vectrix::)?In<Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body,
                      const AngularVelocity<Gcrf, Camera, In<Camera>>& w_gcrf_camera,
                      const AngularVelocity<Gcrf, Body, In<Body>>& w_gcrf_body) {
#ifdef REPAIRED
  static_cast<void>(w_gcrf_camera);
  return rate(R_gcrf_from_body, w_gcrf_body);
#else
  static_cast<void>(w_gcrf_body);
  return rate(R_gcrf_from_body, w_gcrf_camera);
#endif
}
