// mistake: a direction times kilometres
// expect: Gcrf
// expect: convert
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

auto position() {
#ifdef REPAIRED
  return convert<si::length>(7000.0 * si::kilometre) * unit_x(in<Gcrf>);
#else
  return 7000.0 * si::kilometre * unit_x(in<Gcrf>);
#endif
}
