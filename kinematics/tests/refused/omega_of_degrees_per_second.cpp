// mistake: degrees per second given for rad/s
// expect: F = Body
// expect: one SI vector unit for all: convert<U>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate() {
#ifdef REPAIRED
  const auto spin = convert<si::angular_velocity>(0.1 * si::degree_per_second);
  return vector(in<Body>, spin, spin, spin);
#else
  const auto spin = 0.1 * si::degree_per_second;
  return vector(in<Body>, spin, spin, spin);
#endif
}
