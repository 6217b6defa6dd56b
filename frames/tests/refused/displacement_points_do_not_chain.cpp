// mistake: displacements between points that do not chain
// expect: Displacement<Body, CentreOfMass, (vectrix::)?In<Body>
// expect: Displacement<Body, Thruster, (vectrix::)?In<Body>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct CentreOfMass : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto position(const Displacement<Body, CentreOfMass, In<Body>>& r_bc_b,
              const Displacement<Body, Thruster, In<Body>>& r_bt_b) {
#ifdef REPAIRED
  return -r_bc_b + r_bt_b;
#else
  return r_bc_b + r_bt_b;
#endif
}
