// mistake: a rotation without a value
// expect: Dcm<Body, Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

void attitude() {
#ifdef REPAIRED
  const Dcm<Body, Gcrf> R_body_from_gcrf = aligned(to<Body>, from<Gcrf>);
  static_cast<void>(R_body_from_gcrf);
#else
  const Dcm<Body, Gcrf> R_body_from_gcrf;
  static_cast<void>(R_body_from_gcrf);
#endif
}
