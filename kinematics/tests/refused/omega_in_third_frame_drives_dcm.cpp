// mistake: a DCM driven by a rate expressed in a third frame
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of_attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Dcm<Body, Camera>& R_body_from_camera,
                      const AngularVelocity<Gcrf, Body, In<Camera>>& w_camera) {
#ifdef REPAIRED
  return rate(R_gcrf_from_body, R_body_from_camera * w_camera);
#else
  static_cast<void>(R_body_from_camera);
  return rate(R_gcrf_from_body, w_camera);
#endif
}
