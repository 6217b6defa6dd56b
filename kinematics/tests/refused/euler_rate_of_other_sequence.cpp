// mistake: the rates of 3-1-3 angles taken for those of 3-2-1 angles
// expect: Attitude = (vectrix::)?EulerAngles<(vectrix::)?Intrinsic<3, 2, 1>, Gcrf, Body
// expect: Rate = (vectrix::)?ParameterRate<(vectrix::)?EulerAngles<(vectrix::)?Intrinsic<3, 1, 3>, Gcrf, Body
// expect: xdot the rate of that x
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;
using Angles321 = EulerAngles<Intrinsic<3, 2, 1>, Gcrf, Body>;
using Angles313 = EulerAngles<Intrinsic<3, 1, 3>, Gcrf, Body>;

auto rate_of(const Angles321& x, const ParameterRate<Angles321>& xdot,
             const ParameterRate<Angles313>& xdot_313) {
#ifdef REPAIRED
  return static_cast<void>(xdot_313), x.angular_velocity(xdot, in<Body>);
#else
  return static_cast<void>(xdot), x.angular_velocity(xdot_313, in<Body>);
#endif
}
