// mistake: a moving rotation and one whose motion is not known multiplied
// expect: Left = (vectrix::)?MovingDcm<Gcrf, Body
// expect: Right = (vectrix::)?Dcm<Body, Camera
// expect: the kinds go together
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const MovingDcm<Gcrf, Body>& gcrf_from_body, const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return gcrf_from_body * moving_dcm(R_body_from_camera, at_rest(of<Camera>, relative_to<Body>, in<Camera>));
#else
  return gcrf_from_body * R_body_from_camera;
#endif
}
