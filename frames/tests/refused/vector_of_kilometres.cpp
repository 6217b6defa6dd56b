// mistake: kilometres given for metres
// expect: F = Gcrf
// expect: one SI vector unit for all: convert<U>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

auto position() {
#ifdef REPAIRED
  const auto zero = 0.0 * si::metre;
  return vector(in<Gcrf>, convert<si::length>(7000.0 * si::kilometre), zero, zero);
#else
  return vector(in<Gcrf>, 7000.0 * si::kilometre, 0.0 * si::kilometre, 0.0 * si::kilometre);
#endif
}
