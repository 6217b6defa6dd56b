// mistake: a standard deviation in arc seconds, which would be taken for radians
// expect: r_b, r_a, sigma: one direction in two frames, in one unit; an angle in rad
// expect: Vector<Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto observe(const Vector<Body, si::length>& star_b, const Vector<Gcrf, si::length>& star_i) {
#ifdef REPAIRED
  return observation(star_b, star_i, convert<si::angle>(5.0 * si::arcsecond));
#else
  return observation(star_b, star_i, 5.0 * si::arcsecond);
#endif
}
