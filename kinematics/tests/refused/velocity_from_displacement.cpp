// mistake: a place taken for a velocity
// expect: si::length
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Displacement<Gcrf, Tip, In<Body>>& r_b, Quantity<si::time> dt) {
#ifdef REPAIRED
  return velocity(of<Tip>, relative_to<Gcrf>, observed_from<Body>, r_b.vector() / dt);
#else
  return static_cast<void>(dt), velocity(of<Tip>, relative_to<Gcrf>, observed_from<Body>, r_b.vector());
#endif
}
