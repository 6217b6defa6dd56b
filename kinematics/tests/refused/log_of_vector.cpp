// mistake: the logarithm of a rotation vector, which is one already
// expect: Given = (vectrix::)?RotationVector<Gcrf, Body
// expect: of a rotation or a transform
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto turn(const RotationVector<Gcrf, Body>& theta) {
#ifdef REPAIRED
  return vectrix::log(vectrix::exp(theta));
#else
  return vectrix::log(theta);
#endif
}
