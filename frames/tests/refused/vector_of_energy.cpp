// mistake: an energy given for a torque: no vector is an energy
// expect: UnitGiven = (vectrix::)?si::energy
// expect: one SI vector unit
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto torque() {
#ifdef REPAIRED
  return vector(in<Body>, 1.0 * si::newton_metre, 2.0 * si::newton_metre, 3.0 * si::newton_metre);
#else
  return vector(in<Body>, 1.0 * si::joule, 2.0 * si::joule, 3.0 * si::joule);
#endif
}
