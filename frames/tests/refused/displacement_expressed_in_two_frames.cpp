// mistake: displacements expressed in different frames added
// expect: Displacement<Body, CentreOfMass, (vectrix::)?In<Body>
// expect: Displacement<CentreOfMass, Thruster, (vectrix::)?In<Gcrf>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct CentreOfMass : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto position(const Displacement<Body, CentreOfMass, In<Body>>& r_bc_b,
              const Displacement<CentreOfMass, Thruster, In<Gcrf>>& r_ct_i,
              const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  return r_bc_b + R_b_from_i * r_ct_i;
#else
  return static_cast<void>(R_b_from_i), r_bc_b + r_ct_i;
#endif
}
