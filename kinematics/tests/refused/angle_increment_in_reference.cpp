// mistake: the integral of a rate expressed in the reference frame as a count in the body
// expect: angle_increment
// expect: Vector<Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto count([[maybe_unused]] const Vector<Gcrf, si::angle>& alpha_gcrf,
           [[maybe_unused]] const Vector<Body, si::angle>& alpha_body) {
#ifdef REPAIRED
  return angle_increment(of<Body>, relative_to<Gcrf>, alpha_body);
#else
  return angle_increment(of<Body>, relative_to<Gcrf>, alpha_gcrf);
#endif
}
