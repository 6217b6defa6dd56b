// mistake: Euler's equation with an angular momentum for the torque
// expect: TorqueGiven = (vectrix::)?AngularMomentum<
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
                  const Torque<CentreOfMassOf<Body>, In<Body>>& M_body,
                  const AngularMomentum<CentreOfMassOf<Body>, In<Body>>& H_body) {
#ifdef REPAIRED
  return static_cast<void>(H_body), euler(J_body, w_body, M_body);
#else
  return static_cast<void>(M_body), euler(J_body, w_body, H_body);
#endif
}
