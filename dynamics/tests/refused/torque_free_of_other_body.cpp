// mistake: the torque-free motion of one body with the inertia of another
// expect: InertiaOf = Wheel
// expect: StateOf = Body
// expect: one body b
#include <vectrix/dynamics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto tumble([[maybe_unused]] const Inertia<Wheel>& J_wheel, [[maybe_unused]] const Inertia<Body>& J_body,
            const State<Gcrf, Body>& start) {
#ifdef REPAIRED
  return torque_free(J_body, start);
#else
  return torque_free(J_wheel, start);
#endif
}
