// mistake: velocities of points that do not chain added
// expect: Velocity<Body, Camera,
// expect: Velocity<Body, Tip,
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Velocity<Body, Camera, ObservedFrom<Gcrf>, In<Body>>& v_bc,
            const Velocity<Body, Tip, ObservedFrom<Gcrf>, In<Body>>& v_bt) {
#ifdef REPAIRED
  return -v_bc + v_bt;
#else
  return v_bc + v_bt;
#endif
}
