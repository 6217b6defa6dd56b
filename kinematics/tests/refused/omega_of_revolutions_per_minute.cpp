// mistake: revolutions per minute given for rad/s
// expect: F = Wheel<2>
// expect: one SI vector unit for all: convert<U>
#include <vectrix/kinematics.hpp>

struct Body : vectrix::moving_frame {};
template <int I> struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto rate() {
#ifdef REPAIRED
  const auto spin = convert<si::angular_velocity>(6000.0 * si::revolution_per_minute);
  return vector(in<Wheel<2>>, 0.0 * spin, 0.0 * spin, spin);
#else
  const auto spin = 6000.0 * si::revolution_per_minute;
  return vector(in<Wheel<2>>, 0.0 * spin, 0.0 * spin, spin);
#endif
}
