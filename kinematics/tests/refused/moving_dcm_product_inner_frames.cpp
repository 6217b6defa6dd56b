// mistake: two moving rotations whose inner frames do not cancel
// expect: Left = (vectrix::)?MovingDcm<Gcrf, Body
// expect: Right = (vectrix::)?MovingDcm<Camera, Body
// expect: the inner frames cancel
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const MovingDcm<Gcrf, Body>& gcrf_from_body, const MovingDcm<Camera, Body>& camera_from_body) {
#ifdef REPAIRED
  return gcrf_from_body * inverse(camera_from_body);
#else
  return gcrf_from_body * camera_from_body;
#endif
}
