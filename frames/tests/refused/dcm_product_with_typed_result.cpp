// mistake: the type of the result does not make a product lawful, nor the message longer
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto line_of_sight(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  const Vector<Body, si::length> r_body = inverse(R_gcrf_from_body) * r_gcrf;
#else
  const Vector<Body, si::length> r_body = R_gcrf_from_body * r_gcrf;
#endif
  return r_body;
}
