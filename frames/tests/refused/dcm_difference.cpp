// mistake: the difference of two rotations
// expect: Left = (vectrix::)?Dcm<Body, Gcrf
// expect: Right = (vectrix::)?Dcm<Body, Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto error(const Dcm<Body, Gcrf>& R_body_from_gcrf, const Dcm<Body, Gcrf>& estimate) {
#ifdef REPAIRED
  return R_body_from_gcrf * inverse(estimate);
#else
  return R_body_from_gcrf - estimate;
#endif
}
