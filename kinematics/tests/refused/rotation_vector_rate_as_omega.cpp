// mistake: the rate of a rotation vector taken for an angular velocity
// expect: Dcm<Gcrf, Body
// expect: ParameterRate<(vectrix::)?RotationVector<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

DcmRate<Gcrf, Body> motion(const RotationVector<Gcrf, Body>& theta_ab,
                           const ParameterRate<RotationVector<Gcrf, Body>>& thetadot_ab) {
#ifdef REPAIRED
  return rate(exp(theta_ab), theta_ab.angular_velocity(thetadot_ab, in<Body>));
#else
  return rate(exp(theta_ab), thetadot_ab);
#endif
}
