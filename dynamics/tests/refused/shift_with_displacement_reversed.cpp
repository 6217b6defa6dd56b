// mistake: a torque shifted by the displacement from the new point to the old
// expect: Torque<Thruster
// expect: Displacement<Hinge, Thruster
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto about_hinge(const Torque<Thruster, In<Body>>& M_thruster,
                 const Displacement<Hinge, Thruster, In<Body>>& r_ht, const Vector<Body, si::force>& F) {
#ifdef REPAIRED
  return shift(M_thruster, -r_ht, F);
#else
  return shift(M_thruster, r_ht, F);
#endif
}
