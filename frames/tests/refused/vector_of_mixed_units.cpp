// mistake: three coordinates with different units
// expect: F = Body
// expect: UnitGiven = (vectrix::)?si::length
// expect: one SI vector unit
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto position() {
#ifdef REPAIRED
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::metre);
#else
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::second);
#endif
}
