// mistake: nothing is said of the ends of a spline: no claim is made by default
// expect: natural_ends, or w_ab_b at the first and the last
// expect: AttitudeSample<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const std::vector<AttitudeSample<Gcrf, Body>>& samples) {
#ifdef REPAIRED
  return RotationSpline<Gcrf, Body>(samples, 10.0 * si::second, natural_ends);
#else
  return RotationSpline<Gcrf, Body>(samples, 10.0 * si::second);
#endif
}
