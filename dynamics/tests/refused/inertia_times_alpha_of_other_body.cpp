// mistake: the inertia of one body times the angular acceleration of another
// expect: Left = (vectrix::)?Inertia<Wheel
// expect: Right = (vectrix::)?AngularAcceleration<Gcrf, Body
// expect: J_b
#include <vectrix/dynamics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto torque([[maybe_unused]] const Inertia<Wheel>& J_wheel, [[maybe_unused]] const Inertia<Body>& J_body,
            const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_body) {
#ifdef REPAIRED
  return J_body * alpha_body;
#else
  return J_wheel * alpha_body;
#endif
}
