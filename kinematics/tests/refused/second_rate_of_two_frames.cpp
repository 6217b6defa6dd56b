// mistake: a rotation vector's second rate from w expressed in b and alpha expressed in a
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body, (vectrix::)?In<Body>
// expect: Change = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: second_rate\(theta_ab, w_ab_c, alpha_ab_c\)
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto bortz(const RotationVector<Gcrf, Body>& theta_ab, const AngularVelocity<Gcrf, Body, In<Body>>& w_ab_b,
           const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_ab_a) {
#ifdef REPAIRED
  return second_rate(theta_ab, w_ab_b, inverse(exp(theta_ab)) * alpha_ab_a);
#else
  return second_rate(theta_ab, w_ab_b, alpha_ab_a);
#endif
}
