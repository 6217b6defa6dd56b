// mistake: the observations are of the body from Gcrf, the rotation asked for is the other way round
// expect: ToFrame = Gcrf[;,] FromFrame = Body
// expect: Observation<Body, Gcrf>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const std::vector<Observation<Body, Gcrf>>& stars) {
#ifdef REPAIRED
  return inverse(wahba(to<Body>, from<Gcrf>, stars).rotation);
#else
  return wahba(to<Gcrf>, from<Body>, stars);
#endif
}
