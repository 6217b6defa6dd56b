// mistake: a covariance re-expressed by hand, R P R^T, when R * P is that already
// expect: Covariance<Camera
// expect: Dcm<Body, Camera
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto in_camera(const Covariance<Body, si::length>& P_body, const Dcm<Camera, Body>& R_camera_from_body) {
#ifdef REPAIRED
  return R_camera_from_body * P_body;
#else
  return R_camera_from_body * P_body * inverse(R_camera_from_body);
#endif
}
