// mistake: the kinetic energy from the inertia about a point that may move
// expect: InertiaAbout = Hinge
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto energy(const Inertia<Body, Hinge>& J_hinge, const Inertia<Body>& J_body,
            const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return static_cast<void>(J_hinge), kinetic_energy(J_body, w_body);
#else
  return static_cast<void>(J_body), kinetic_energy(J_hinge, w_body);
#endif
}
