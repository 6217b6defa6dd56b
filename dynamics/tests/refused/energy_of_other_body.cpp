// mistake: the kinetic energy of the inertia of one body with the rate of another
// expect: kinetic_energy
// expect: Wheel
// expect: Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
auto energy(const Inertia<Wheel>& J_wheel, const AngularVelocity<Eci, Wheel, In<Wheel>>& w_wheel) {
#else
auto energy(const Inertia<Wheel>& J_wheel, const AngularVelocity<Eci, Body, In<Body>>& w_wheel) {
#endif
  return kinetic_energy(J_wheel, w_wheel);
}
