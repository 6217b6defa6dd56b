// mistake: a step with what a gyro measured, its errors included
// expect: Rotation = (vectrix::)?Dcm<Gcrf, Body
// expect: Rate = (vectrix::)?Measured<
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto step(const Dcm<Gcrf, Body>& R_gcrf_from_body,
          const Measured<AngularVelocity<Gcrf, Body, In<Body>>>& reading,
          [[maybe_unused]] const GyroErrors<Body>& errors, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return exponential_step(R_gcrf_from_body, errors.corrected(reading), dt);
#else
  return exponential_step(R_gcrf_from_body, reading, dt);
#endif
}
