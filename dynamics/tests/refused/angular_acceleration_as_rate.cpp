// mistake: what Euler's equation gives, taken for an angular velocity
// expect: AngularAcceleration<Eci, Body
// expect: AngularVelocity<Eci, Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto after(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body,
           const Vector<Body, si::torque>& torque_body) {
#ifdef REPAIRED
  const AngularAcceleration<Eci, Body, In<Body>> change = euler(J_body, w_body, torque_body);
#else
  const AngularVelocity<Eci, Body, In<Body>> change = euler(J_body, w_body, torque_body);
#endif
  return change;
}
