// mistake: the second derivative of a quaternion from a rate in b and an acceleration in a
// expect: X = (vectrix::)?Quaternion<Gcrf, Body
// expect: Acceleration = (vectrix::)?AngularAcceleration<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: both expressed in b, or both in a
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto second(const Quaternion<Gcrf, Body>& q_i_from_b, const AngularVelocity<Gcrf, Body, In<Body>>& w_b,
            const AngularAcceleration<Gcrf, Body, In<Gcrf>>& alpha_i) {
#ifdef REPAIRED
  return second_rate(q_i_from_b, w_b, inverse(q_i_from_b) * alpha_i);
#else
  return second_rate(q_i_from_b, w_b, alpha_i);
#endif
}
