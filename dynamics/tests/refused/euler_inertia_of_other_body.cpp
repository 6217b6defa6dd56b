// mistake: Euler's equation of one body with the inertia of another
// expect: InertiaOf = Wheel
// expect: RateOf = Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
auto acceleration(const Inertia<Body>& J, const AngularVelocity<Eci, Body, In<Body>>& w_body,
#else
auto acceleration(const Inertia<Wheel>& J, const AngularVelocity<Eci, Body, In<Body>>& w_body,
#endif
                  const Vector<Body, si::torque>& torque_body) {
  return euler(J, w_body, torque_body);
}
