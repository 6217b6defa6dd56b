// mistake: the mean of rotations from the body, asked for as one to it
// expect: ToFrame = Body[;,] FromFrame = Gcrf
// expect: Quaternion<Gcrf, Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto average(const std::vector<Quaternion<Gcrf, Body>>& attitudes) {
#ifdef REPAIRED
  return inverse(mean_rotation(to<Gcrf>, from<Body>, attitudes).rotation);
#else
  return mean_rotation(to<Body>, from<Gcrf>, attitudes);
#endif
}
