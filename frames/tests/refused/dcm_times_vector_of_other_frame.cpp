// mistake: a rotation applied to a vector that is not expressed in its inner frame
// expect: DcmFrom = Gcrf
// expect: VectorIn = Body
// expect: r must be expressed in a
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
