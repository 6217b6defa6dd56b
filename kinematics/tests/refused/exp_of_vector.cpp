// mistake: the exponential of a vector, which does not know its two frames
// expect: Given = (vectrix::)?Vector<Body, (vectrix::)?si::angle
// expect: of a rotation vector or a screw
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Vector<Body, si::angle>& theta_body) {
#ifdef REPAIRED
  return vectrix::exp(rotation_vector(of<Body>, relative_to<Gcrf>, theta_body));
#else
  return vectrix::exp(theta_body);
#endif
}
