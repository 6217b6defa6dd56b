// mistake: a torque made of energies, which are joules, not newton metres
// expect: UnitGiven = (vectrix::)?si::energy
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const Inertia<Body>& J_body, const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  const auto unit = si::newton_metre;
#else
  const auto unit = si::joule;
#endif
  const Vector<Body, si::torque> torque = vector(in<Body>, 1.0 * unit, 2.0 * unit, 3.0 * unit);
  return euler(J_body, w_body, torque);
}
