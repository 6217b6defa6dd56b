// mistake: metres per second at a door for metres
// expect: si::velocity
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct CentreOfMass : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto position(const Vector<Body, si::velocity>& v_b, const Quantity<si::time>& t) {
#ifdef REPAIRED
  return displacement(of<Thruster>, relative_to<Body>, v_b * t);
#else
  return static_cast<void>(t), displacement(of<Thruster>, relative_to<Body>, v_b);
#endif
}
