// mistake: the angular acceleration of a quaternion from the derivatives of its inverse
// expect: Attitude = (vectrix::)?Quaternion<Gcrf, Body
// expect: Rate = (vectrix::)?QuaternionRate<Body, Gcrf
// expect: q_a_from_b.angular_acceleration.qdot_a_from_b, qddot_a_from_b, in<B>. or in<A>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Quaternion<Gcrf, Body>& q_i_from_b, const QuaternionRate<Body, Gcrf>& qdot_b_from_i,
                  const QuaternionSecondRate<Body, Gcrf>& qddot_b_from_i) {
#ifdef REPAIRED
  return inverse(q_i_from_b).angular_acceleration(qdot_b_from_i, qddot_b_from_i, in<Body>);
#else
  return q_i_from_b.angular_acceleration(qdot_b_from_i, qddot_b_from_i, in<Body>);
#endif
}
