// mistake: metres per second squared at a door for metres per second
// expect: si::acceleration
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Vector<Body, si::acceleration>& a_b, const Quantity<si::time>& t) {
#ifdef REPAIRED
  return velocity(of<Tip>, relative_to<Body>, observed_from<Body>, a_b * t);
#else
  return static_cast<void>(t), velocity(of<Tip>, relative_to<Body>, observed_from<Body>, a_b);
#endif
}
