// mistake: the inertia of one body times the rate of another
// expect: Inertia<Wheel
// expect: AngularVelocity<Eci, Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto momentum(const Inertia<Wheel>& J_wheel, const AngularVelocity<Eci, Wheel, In<Wheel>>& w_wheel,
              const AngularVelocity<Eci, Body, In<Body>>& w_body) {
#ifdef REPAIRED
  return static_cast<void>(w_body), J_wheel * w_wheel;
#else
  return static_cast<void>(w_wheel), J_wheel * w_body;
#endif
}
