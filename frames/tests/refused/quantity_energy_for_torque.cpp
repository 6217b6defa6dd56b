// mistake: an energy given for a torque
// expect: quantity
#include <vectrix/frames.hpp>

using namespace vectrix;

auto torque() {
#ifdef REPAIRED
  const Quantity<si::torque> tau = 2.0 * si::newton_metre;
  return tau;
#else
  const Quantity<si::torque> tau = 2.0 * si::joule;
  return tau;
#endif
}
