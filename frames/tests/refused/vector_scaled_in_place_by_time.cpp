// mistake: a product that would change the unit, in place
// expect: Left = (vectrix::)?Vector<Body, (vectrix::)?si::velocity
// expect: a product of the same type
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

void faster(Vector<Body, si::velocity>& v_body, const Quantity<si::time>& step) {
#ifdef REPAIRED
  v_body *= step / (1.0 * si::second);
#else
  v_body *= step;
#endif
}
