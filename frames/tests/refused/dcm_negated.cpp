// mistake: the negative of a rotation
// expect: Dcm<Body, Gcrf
// expect: a rotation has no negative
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto reverse(const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return inverse(R_body_from_gcrf);
#else
  return -R_body_from_gcrf;
#endif
}
