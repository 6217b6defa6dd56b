// mistake: the acceleration of a particle from a twist at one point and its rate at another
// expect: Motion = (vectrix::)?Twist<Gcrf, Body, (vectrix::)?At<Camera>
// expect: Change = (vectrix::)?TwistRate<Gcrf, Body, (vectrix::)?At<Body>
// expect: at one point, expressed in one frame
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto push(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ab,
          const TwistRate<Gcrf, Body, At<Body>, In<Body>>& Vdot_ab,
          const Displacement<Body, Camera, In<Body>>& r_bc_b) {
#ifdef REPAIRED
  return particle_acceleration(shift(V_ab, r_bc_b), shift(Vdot_ab, r_bc_b));
#else
  return particle_acceleration(shift(V_ab, r_bc_b), Vdot_ab);
#endif
}
