// mistake: the exponential of a twist, without the time for which it is held
// expect: Given = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Body>
// expect: of a rotation vector or a screw
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto place(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ab_b, Quantity<si::time> t) {
#ifdef REPAIRED
  return vectrix::exp(held(V_ab_b, t));
#else
  static_cast<void>(t);
  return vectrix::exp(V_ab_b);
#endif
}
