// mistake: a covariance re-expressed by the rotation that leads to its frame instead of from it
// expect: Dcm<Body, Camera
// expect: Covariance<Body
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto in_camera(const Covariance<Body, si::length>& P_body, const Dcm<Body, Camera>& R_body_from_camera) {
#ifdef REPAIRED
  return inverse(R_body_from_camera) * P_body;
#else
  return R_body_from_camera * P_body;
#endif
}
