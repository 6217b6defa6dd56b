// mistake: a twist at b's origin held in a's axes, whose motion is no exponential
// expect: Motion = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Gcrf>
// expect: V_ab held at b in b, or at a in a
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto later(const Transform<Gcrf, Body>& X_a_from_b, const Twist<Gcrf, Body, At<Body>, In<Gcrf>>& V_ab_a,
           Quantity<si::time> t) {
#ifdef REPAIRED
  return moved(X_a_from_b, inverse(X_a_from_b.rotation) * V_ab_a, t);
#else
  return moved(X_a_from_b, V_ab_a, t);
#endif
}
