// mistake: the exponential of the integral of a rate, which is no rotation vector
// expect: exp
// expect: Given = (vectrix::)?AngleIncrement<Gcrf, Body
// expect: of a rotation vector or a screw
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const AngleIncrement<Gcrf, Body>& first, const AngleIncrement<Gcrf, Body>& second) {
#ifdef REPAIRED
  return vectrix::exp(coning_corrected(first, second));
#else
  return vectrix::exp(first + second);
#endif
}
