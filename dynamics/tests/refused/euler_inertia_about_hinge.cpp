// mistake: Euler's equation, about the centre of mass, with the inertia about a hinge
// expect: InertiaAbout = Hinge
// expect: InertiaOf = Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto acceleration(const Inertia<Body, Hinge>& J_hinge, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Vector<Body, si::torque>& torque_body,
                  const Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>& r_hc,
                  const Quantity<si::mass>& mass) {
#ifdef REPAIRED
  return euler(shift(J_hinge, r_hc, mass), w_body, torque_body);
#else
  return static_cast<void>(r_hc), static_cast<void>(mass), euler(J_hinge, w_body, torque_body);
#endif
}
