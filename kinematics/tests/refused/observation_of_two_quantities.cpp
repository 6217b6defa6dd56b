// mistake: a line of sight is said to be the magnetic force in the other frame
// expect: Vector<Body, vectrix::si::length
// expect: Vector<Gcrf, vectrix::si::force
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto observe(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
             const Vector<Gcrf, si::force>& pull_i) {
#ifdef REPAIRED
  static_cast<void>(pull_i);
  return observation(sun_b, sun_i, 0.01 * si::radian);
#else
  static_cast<void>(sun_i);
  return observation(sun_b, pull_i, 0.01 * si::radian);
#endif
}
