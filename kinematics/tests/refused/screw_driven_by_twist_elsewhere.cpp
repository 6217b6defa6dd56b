// mistake: a screw driven by the twist at b's origin in a's axes, neither the body nor the reference form
// expect: Screw<Gcrf, Body
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Gcrf>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto change(const Screw<Gcrf, Body>& xi_ab, const Twist<Gcrf, Body, At<Body>, In<Gcrf>>& V_ab_a) {
#ifdef REPAIRED
  return rate(xi_ab, inverse(exp(xi_ab).rotation) * V_ab_a);
#else
  return rate(xi_ab, V_ab_a);
#endif
}
