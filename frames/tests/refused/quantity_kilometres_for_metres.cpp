// mistake: kilometres given for metres
// expect: quantity
// expect: Quantity<si::length>|scale<10
#include <vectrix/frames.hpp>

using namespace vectrix;

void apply(Quantity<si::length> given);

void use() {
#ifdef REPAIRED
  apply(convert<si::length>(400.0 * si::kilometre));
#else
  apply(400.0 * si::kilometre);
#endif
}
