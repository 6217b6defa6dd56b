// mistake: Euler's equation relative to the rotating Earth
// expect: RotatingReference = Itrf
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
using Reference = Gcrf;
#else
using Reference = Itrf;
#endif

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Reference, Body, In<Body>>& w_body,
                  const Vector<Body, si::torque>& torque_body) {
  return euler(J_body, w_body, torque_body);
}
