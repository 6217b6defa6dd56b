// mistake: torques about different points added
// expect: Torque<Hinge
// expect: Torque<Thruster
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto total(const Torque<Hinge, In<Body>>& M_hinge, const Torque<Thruster, In<Body>>& M_thruster,
           const Displacement<Thruster, Hinge, In<Body>>& r_th, const Vector<Body, si::force>& F) {
#ifdef REPAIRED
  return M_hinge + shift(M_thruster, r_th, F);
#else
  return static_cast<void>(r_th), static_cast<void>(F), M_hinge + M_thruster;
#endif
}
