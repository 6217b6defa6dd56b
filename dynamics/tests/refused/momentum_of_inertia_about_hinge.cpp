// mistake: the inertia about a point that may move, times the rate, as the momentum about the centre of mass
// expect: Inertia<Body, Hinge
// expect: AngularVelocity<Eci, Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto momentum(const Inertia<Body, Hinge>& J_hinge, const Inertia<Body>& J_body,
              const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return static_cast<void>(J_hinge), J_body * w_body;
#else
  return static_cast<void>(J_body), J_hinge * w_body;
#endif
}
