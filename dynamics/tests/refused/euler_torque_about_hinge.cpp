// mistake: Euler's equation with the torque about a hinge
// expect: Torque<Hinge
// expect: InertiaAbout = (vectrix::)?CentreOfMassOf<Body>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Torque<Hinge, In<Body>>& M_hinge,
                  const Displacement<Hinge, CentreOfMassOf<Body>, In<Body>>& r_hc,
                  const Vector<Body, si::force>& F) {
#ifdef REPAIRED
  return euler(J_body, w_body, shift(M_hinge, r_hc, F));
#else
  return static_cast<void>(r_hc), static_cast<void>(F), euler(J_body, w_body, M_hinge);
#endif
}
