// mistake: the inertia of one body with the initial state of another
// expect: State<Gcrf, Wheel>
// expect: State<Gcrf, Body>
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto flight(const Inertia<Body>& J_body, const State<Gcrf, Body>& body, const State<Gcrf, Wheel>& wheel) {
#ifdef REPAIRED
  static_cast<void>(wheel);
  const Scenario<Gcrf, Body> scenario{.inertia = J_body, .initial = body};
#else
  static_cast<void>(body);
  const Scenario<Gcrf, Body> scenario{.inertia = J_body, .initial = wheel};
#endif
  return scenario;
}
