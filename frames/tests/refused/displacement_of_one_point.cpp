// mistake: a point given a place relative to itself
// expect: Q = Body
// expect: P = Body
// expect: two points
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto place(const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return displacement(of<Hinge>, relative_to<Body>, r_body);
#else
  return displacement(of<Body>, relative_to<Body>, r_body);
#endif
}
