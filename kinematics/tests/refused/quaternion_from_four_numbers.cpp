// mistake: four numbers that do not say where the scalar is
// expect: Quaternion<Body, Gcrf
// expect: where is the scalar
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude() {
#ifdef REPAIRED
  return quaternion_scalar_first(to<Body>, from<Gcrf>, 1.0, 0.0, 0.0, 0.0);
#else
  return Quaternion<Body, Gcrf>(1.0, 0.0, 0.0, 0.0);
#endif
}
