// mistake: the velocity of a camera from the twist at the body's origin
// expect: OfPoint = Camera
// expect: Motion = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Body>
// expect: the twist at q
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto camera_velocity(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ab,
                     const Displacement<Body, Camera, In<Body>>& r_bc_b) {
#ifdef REPAIRED
  return point_velocity(of<Camera>, shift(V_ab, r_bc_b));
#else
  static_cast<void>(r_bc_b);
  return point_velocity(of<Camera>, V_ab);
#endif
}
