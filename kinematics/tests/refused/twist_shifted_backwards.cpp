// mistake: a twist shifted by the position of the wrong end
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>
// expect: Displacement<Tip, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ib,
            const Displacement<Tip, Body, In<Body>>& r_tb_b) {
#ifdef REPAIRED
  return shift(V_ib, -r_tb_b);
#else
  return shift(V_ib, r_tb_b);
#endif
}
