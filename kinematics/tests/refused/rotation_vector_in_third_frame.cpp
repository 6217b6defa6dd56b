// mistake: a rotation vector expressed in neither of its two frames
// expect: VectorIn = Camera
// expect: OfFrame = Body
// expect: between two frames, expressed in one of them
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const Vector<Camera, si::angle>& theta_camera, const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return rotation_vector(of<Body>, relative_to<Gcrf>, R_body_from_camera * theta_camera);
#else
  static_cast<void>(R_body_from_camera);
  return rotation_vector(of<Body>, relative_to<Gcrf>, theta_camera);
#endif
}
