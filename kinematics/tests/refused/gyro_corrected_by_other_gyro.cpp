// mistake: what the gyro of one body measured freed of the errors of another's
// expect: corrected
// expect: Given = (vectrix::)?Measured<
// expect: Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto rate(const Measured<AngularVelocity<Gcrf, Body, In<Body>>>& reading_body,
          [[maybe_unused]] const GyroErrors<Body>& of_body,
          [[maybe_unused]] const GyroErrors<Camera>& of_camera) {
#ifdef REPAIRED
  return of_body.corrected(reading_body);
#else
  return of_camera.corrected(reading_body);
#endif
}
