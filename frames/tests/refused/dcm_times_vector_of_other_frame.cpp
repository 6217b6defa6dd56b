// mistake: a rotation applied to a vector that is not expressed in its inner frame
// expect: Left = (vectrix::)?Dcm<Body, Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto position(const Dcm<Body, Gcrf>& R_body_from_gcrf, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return inverse(R_body_from_gcrf) * r_body;
#else
  return R_body_from_gcrf * r_body;
#endif
}
