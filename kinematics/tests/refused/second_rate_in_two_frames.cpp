// mistake: a rate expressed in b and an acceleration expressed in a
// expect: X = (vectrix::)?EulerAngles<(vectrix::)?Intrinsic<3, 2, 1>, Gcrf, Body
// expect: Acceleration = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: both expressed in b, or both in a
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto second(const EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body>& x,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_b,
            const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_i, const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  return second_rate(x, w_b, R_b_from_i * alpha_i);
#else
  return static_cast<void>(R_b_from_i), second_rate(x, w_b, alpha_i);
#endif
}
