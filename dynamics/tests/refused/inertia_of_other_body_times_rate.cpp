// mistake: the inertia of one body times the rate of another
// expect: InertiaOf = Wheel
// expect: RateOf = Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
auto momentum(const Inertia<Wheel>& J_wheel, const AngularVelocity<Gcrf, Wheel, In<Wheel>>& w_wheel) {
#else
auto momentum(const Inertia<Wheel>& J_wheel, const AngularVelocity<Gcrf, Body, In<Body>>& w_wheel) {
#endif
  return J_wheel * w_wheel;
}
