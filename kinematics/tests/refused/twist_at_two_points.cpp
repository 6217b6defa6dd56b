// mistake: twists taken at different points added
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>
// expect: Twist<Body, Camera, (vectrix::)?At<Tip>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ib,
            const Twist<Body, Camera, At<Tip>, In<Body>>& V_bc,
            const Displacement<Body, Tip, In<Body>>& r_bt_b) {
#ifdef REPAIRED
  return shift(V_ib, r_bt_b) + V_bc;
#else
  return static_cast<void>(r_bt_b), V_ib + V_bc;
#endif
}
