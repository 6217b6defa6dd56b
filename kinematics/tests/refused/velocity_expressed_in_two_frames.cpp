// mistake: velocities expressed in different frames added
// expect: Velocity<Body, Camera,.*In<Gcrf>
// expect: Velocity<Camera, Tip,.*In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Velocity<Body, Camera, ObservedFrom<Gcrf>, In<Gcrf>>& v_bc_i,
            const Velocity<Camera, Tip, ObservedFrom<Gcrf>, In<Body>>& v_ct_b,
            const Dcm<Gcrf, Body>& R_i_from_b) {
#ifdef REPAIRED
  return v_bc_i + R_i_from_b * v_ct_b;
#else
  return static_cast<void>(R_i_from_b), v_bc_i + v_ct_b;
#endif
}
