// mistake: a vector of another frame added in place
// expect: Left = (vectrix::)?Vector<Body
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: a sum of the same type
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

void shift(Vector<Body, si::length>& r_body, const Dcm<Body, Gcrf>& R_body_from_gcrf,
           const Vector<Gcrf, si::length>& shift_gcrf) {
#ifdef REPAIRED
  r_body += R_body_from_gcrf * shift_gcrf;
#else
  r_body += shift_gcrf;
#endif
}
