// mistake: Euler's equation relative to the rotating Earth
// expect: RateRelativeTo = Ecef
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Ecef : vectrix::moving_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
using Reference = Eci;
#else
using Reference = Ecef;
#endif

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Reference, Body, In<Body>>& w_body,
                  const Vector<Body, si::torque>& torque_body) {
  return euler(J_body, w_body, torque_body);
}
