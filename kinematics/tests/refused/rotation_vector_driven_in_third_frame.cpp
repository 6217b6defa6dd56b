// mistake: a rotation vector driven by an angular velocity expressed in a third frame
// expect: RotationVector<Gcrf, Body
// expect: AngularVelocity<Gcrf, Body, (vectrix::)?In<Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto bortz(const RotationVector<Gcrf, Body>& theta_ab, const AngularVelocity<Gcrf, Body, In<Camera>>& w_ab_c,
           const Dcm<Body, Camera>& R_b_from_c) {
#ifdef REPAIRED
  return rate(theta_ab, R_b_from_c * w_ab_c);
#else
  static_cast<void>(R_b_from_c);
  return rate(theta_ab, w_ab_c);
#endif
}
