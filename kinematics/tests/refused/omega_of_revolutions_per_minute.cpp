// mistake: revolutions per minute given for rad/s
// expect: F = Wheel<2>
// expect: no vector has this unit: convert<U>
#include <vectrix/kinematics.hpp>

struct Body : vectrix::moving_frame {};
template <int I> struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto rate() {
#ifdef REPAIRED
  const auto spin = convert<si::angular_velocity>(6000.0 * si::revolution_per_minute);
  return angular_velocity(of<Wheel<2>>, relative_to<Body>,
                          vector(in<Wheel<2>>, 0.0 * spin, 0.0 * spin, spin));
#else
  const auto spin = 6000.0 * si::revolution_per_minute;
  return angular_velocity(of<Wheel<2>>, relative_to<Body>,
                          vector(in<Wheel<2>>, 0.0 * spin, 0.0 * spin, spin));
#endif
}
