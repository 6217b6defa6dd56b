// mistake: two turns in a row about one axis, which are one turn
// expect: Sequence = (vectrix::)?Intrinsic<3, 3, 1>
// expect: no axis twice in a row
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(Quantity<si::angle> first, Quantity<si::angle> second, Quantity<si::angle> third) {
#ifdef REPAIRED
  return euler_angles(intrinsic<3, 1, 3>, of<Body>, relative_to<Gcrf>, first, second, third);
#else
  return euler_angles(intrinsic<3, 3, 1>, of<Body>, relative_to<Gcrf>, first, second, third);
#endif
}
