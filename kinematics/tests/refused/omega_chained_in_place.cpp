// mistake: a chain of rates is the rate of another pair than its first
// expect: Left = (vectrix::)?AngularVelocity<Gcrf, Body
// expect: Right = (vectrix::)?AngularVelocity<Body, Wheel
// expect: a chain is another
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto spin(AngularVelocity<Gcrf, Body, In<Body>> w_body,
          const AngularVelocity<Body, Wheel, In<Body>>& w_wheel) {
#ifdef REPAIRED
  return w_body + w_wheel;
#else
  return w_body += w_wheel;
#endif
}
