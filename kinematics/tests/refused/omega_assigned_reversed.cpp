// mistake: w_ba assigned to a variable of type w_ab
// expect: AngularVelocity<Body, Gcrf
// expect: AngularVelocity<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

AngularVelocity<Gcrf, Body, In<Body>> rate(const AngularVelocity<Body, Gcrf, In<Body>>& w_body_gcrf) {
#ifdef REPAIRED
  return -w_body_gcrf;
#else
  return w_body_gcrf;
#endif
}
