// mistake: a transform moved by the twist of another frame
// expect: TransformTo = Gcrf
// expect: TransformFrom = Body
// expect: Motion = (vectrix::)?Twist<Gcrf, Camera, (vectrix::)?At<Camera>, (vectrix::)?In<Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto later(const Transform<Gcrf, Body>& X_a_from_b, const Transform<Gcrf, Camera>& X_a_from_c,
           const Twist<Gcrf, Camera, At<Camera>, In<Camera>>& V_ac_c, Quantity<si::time> t) {
#ifdef REPAIRED
  static_cast<void>(X_a_from_b);
  return moved(X_a_from_c, V_ac_c, t);
#else
  static_cast<void>(X_a_from_c);
  return moved(X_a_from_b, V_ac_c, t);
#endif
}
