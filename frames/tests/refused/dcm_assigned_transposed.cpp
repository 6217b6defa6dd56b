// mistake: R_a_from_b assigned to a variable of type R_b_from_a
// expect: Dcm<Gcrf, Body
// expect: Dcm<Body, Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

void attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  const Dcm<Body, Gcrf> R_body_from_gcrf = inverse(R_gcrf_from_body);
  static_cast<void>(R_body_from_gcrf);
#else
  const Dcm<Body, Gcrf> R_body_from_gcrf = R_gcrf_from_body;
  static_cast<void>(R_body_from_gcrf);
#endif
}
