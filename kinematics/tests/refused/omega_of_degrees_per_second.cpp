// mistake: degrees per second given for rad/s
// expect: F = Body
// expect: no vector has this unit: convert<U>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate() {
#ifdef REPAIRED
  const auto spin = convert<si::angular_velocity>(0.1 * si::degree_per_second);
  return angular_velocity(of<Body>, relative_to<Gcrf>, vector(in<Body>, spin, spin, spin));
#else
  const auto spin = 0.1 * si::degree_per_second;
  return angular_velocity(of<Body>, relative_to<Gcrf>, vector(in<Body>, spin, spin, spin));
#endif
}
