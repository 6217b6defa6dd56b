// mistake: a vector without a value
// expect: Vector<Body, (vectrix::)?si::length
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto position() {
#ifdef REPAIRED
  const Vector<Body, si::length> r_body = zero<si::length>(in<Body>);
  return r_body;
#else
  const Vector<Body, si::length> r_body;
  return r_body;
#endif
}
