// mistake: parallel axes between two points of which none is the centre of mass
// expect: Inertia<Body, Hinge
// expect: Displacement<Hinge, Thruster
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};
struct Thruster : vectrix::named_point {};

using namespace vectrix;

auto about_thruster(const Inertia<Body, Hinge>& J_hinge, const Displacement<Hinge, Thruster, In<Body>>& r_ht,
                    const Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>& r_hc,
                    const Quantity<si::mass>& m) {
#ifdef REPAIRED
  return shift(shift(J_hinge, r_hc, m), -r_hc + r_ht, m);
#else
  return static_cast<void>(r_hc), shift(J_hinge, r_ht, m);
#endif
}
