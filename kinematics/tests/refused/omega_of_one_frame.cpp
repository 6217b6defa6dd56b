// mistake: the rate of a frame relative to itself
// expect: Of<Body>
// expect: RelativeTo<Body>
// expect: two frames
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto spin(const Vector<Body, si::angular_velocity>& w_body) {
#ifdef REPAIRED
  return angular_velocity(of<Body>, relative_to<Gcrf>, w_body);
#else
  return angular_velocity(of<Body>, relative_to<Body>, w_body);
#endif
}
