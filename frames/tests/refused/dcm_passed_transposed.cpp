// mistake: R_a_from_b passed to a function that takes R_b_from_a
// expect: Dcm<Gcrf, Body
// expect: Dcm<Body, Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

void point(const Dcm<Body, Gcrf>& R_body_from_gcrf);

void control(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  point(inverse(R_gcrf_from_body));
#else
  point(R_gcrf_from_body);
#endif
}
