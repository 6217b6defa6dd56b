// mistake: the scenario of one body with the initial state of another
// expect: State<.*, Wheel>
// expect: State<.*, Body>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
auto start(Scenario<Eci, Body> scenario, const State<Eci, Body>& state) {
#else
auto start(Scenario<Eci, Body> scenario, const State<Eci, Wheel>& state) {
#endif
  scenario.initial = state;
  return scenario;
}
