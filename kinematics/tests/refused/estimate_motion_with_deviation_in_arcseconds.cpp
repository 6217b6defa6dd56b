// mistake: the deviation of the samples in arc seconds, which would be taken for radians
// expect: samples of b relative to a, t and half width in s, sigma in rad
// expect: AttitudeSample<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto estimate(const std::vector<AttitudeSample<Gcrf, Body>>& samples) {
#ifdef REPAIRED
  return estimate_motion(samples, 10.0 * si::second, 2.0 * si::second,
                         convert<si::angle>(5.0 * si::arcsecond));
#else
  return estimate_motion(samples, 10.0 * si::second, 2.0 * si::second, 5.0 * si::arcsecond);
#endif
}
