// mistake: an angular velocity given for the rates of Euler angles
// expect: Rate = (vectrix::)?AngularVelocity<Gcrf, Body
// expect: xdot the rate of that x
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of(const EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body>& x,
             const AngularVelocity<Gcrf, Body, In<Body>>& w_b) {
#ifdef REPAIRED
  return x.angular_velocity(rate(x, w_b), in<Gcrf>);
#else
  return x.angular_velocity(w_b, in<Gcrf>);
#endif
}
