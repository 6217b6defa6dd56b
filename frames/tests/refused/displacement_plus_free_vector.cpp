// mistake: a free vector added to a displacement, whose end it would not name
// expect: Displacement<Body, CentreOfMass, (vectrix::)?In<Body>
// expect: Vector<Body
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct CentreOfMass : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto position(const Displacement<Body, CentreOfMass, In<Body>>& r_bc_b, const Vector<Body, si::length>& s_b) {
#ifdef REPAIRED
  return r_bc_b + displacement(of<Thruster>, relative_to<CentreOfMass>, s_b);
#else
  return r_bc_b + s_b;
#endif
}
