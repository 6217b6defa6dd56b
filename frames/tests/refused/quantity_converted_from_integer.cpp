// mistake: whole degrees converted, which would be cut to whole radians
// expect: a whole number would be cut
// expect: int
#include <vectrix/frames.hpp>

using namespace vectrix;

Quantity<si::angle> right_angle() {
#ifdef REPAIRED
  return convert<si::angle>(90.0 * si::degree);
#else
  return convert<si::angle>(90 * si::degree);
#endif
}
