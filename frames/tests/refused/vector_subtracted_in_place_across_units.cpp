// mistake: a velocity subtracted from a position in place
// expect: si::length
// expect: si::velocity
// expect: a difference of the same type
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

void back(Vector<Body, si::length>& r_body, const Vector<Body, si::velocity>& v_body,
          const Quantity<si::time>& step) {
#ifdef REPAIRED
  r_body -= v_body * step;
#else
  r_body -= v_body;
#endif
}
