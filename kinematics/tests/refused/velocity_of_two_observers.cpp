// mistake: velocities seen by different observers added
// expect: Velocity<Body, Camera, (vectrix::)?ObservedFrom<Gcrf>
// expect: Velocity<Camera, Tip, (vectrix::)?ObservedFrom<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Velocity<Body, Camera, ObservedFrom<Gcrf>, In<Body>>& v_bc_i_b,
            const Velocity<Camera, Tip, ObservedFrom<Body>, In<Body>>& v_ct_b_b,
            const Displacement<Camera, Tip, In<Body>>& r_ct_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return v_bc_i_b + transport(observed_from<Gcrf>, v_ct_b_b, r_ct_b, w_ib_b);
#else
  return static_cast<void>(r_ct_b), static_cast<void>(w_ib_b), v_bc_i_b + v_ct_b_b;
#endif
}
