// mistake: the angular acceleration of a frame relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto spin(const Vector<Body, si::angular_acceleration>& alpha_body) {
#ifdef REPAIRED
  return angular_acceleration(of<Body>, relative_to<Gcrf>, alpha_body);
#else
  return angular_acceleration(of<Body>, relative_to<Body>, alpha_body);
#endif
}
