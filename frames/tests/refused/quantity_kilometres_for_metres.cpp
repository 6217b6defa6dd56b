// mistake: kilometres given for metres
// expect: quantity
#include <vectrix/frames.hpp>

using namespace vectrix;

auto altitude() {
#ifdef REPAIRED
  const Quantity<si::length> h = convert<si::length>(400.0 * si::kilometre);
  return h;
#else
  const Quantity<si::length> h = 400.0 * si::kilometre;
  return h;
#endif
}
