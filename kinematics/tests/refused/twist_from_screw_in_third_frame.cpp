// mistake: the twist of a screw that changes, asked in neither of its two frames
// expect: Screw<A, B, S>|Screw<Gcrf, Body
// expect: Expressed = (vectrix::)?In<Camera>
// expect: twist_from.xi_ab, xidot_ab, in<B>. or in<A>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const Screw<Gcrf, Body>& xi_ab, const ScrewRate<Gcrf, Body>& xidot_ab,
            const Transform<Camera, Body>& X_c_from_b) {
#ifdef REPAIRED
  return X_c_from_b * twist_from(xi_ab, xidot_ab, in<Body>);
#else
  static_cast<void>(X_c_from_b);
  return twist_from(xi_ab, xidot_ab, in<Camera>);
#endif
}
