// mistake: a line of an attitude file that takes Gcrf to the body, kept as one that takes the body to Gcrf
// expect: Quaternion<Body, ?Gcrf
// expect: Quaternion<Gcrf, ?Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto line(const Quantity<si::time>& t, const Quaternion<Body, Gcrf>& q_b_from_i) {
#ifdef REPAIRED
  return AttitudeSample<Gcrf, Body>{t, inverse(q_b_from_i)};
#else
  return AttitudeSample<Gcrf, Body>{t, q_b_from_i};
#endif
}
