// mistake: an energy given for a torque
// expect: quantity
// expect: Quantity<si::torque>|plane_angle_base_dimension
#include <vectrix/frames.hpp>

using namespace vectrix;

void apply(Quantity<si::torque> given);

void use() {
#ifdef REPAIRED
  apply(2.0 * si::newton_metre);
#else
  apply(2.0 * si::joule);
#endif
}
