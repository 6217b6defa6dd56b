// mistake: a vector turned within a frame in which it is not expressed
// expect: DcmTo = Gcrf
// expect: VectorIn = Body
// expect: r is turned within a
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return rotate(R_gcrf_from_body, R_gcrf_from_body * r_body);
#else
  return rotate(R_gcrf_from_body, r_body);
#endif
}
