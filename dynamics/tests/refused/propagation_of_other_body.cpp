// mistake: the scenario of one body with the roots and settings of another
// expect: propagate
// expect: Wheel
// expect: Body
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
auto flight(const Scenario<Eci, Body>& scenario, const Propagation<Eci, Body>& how) {
#else
auto flight(const Scenario<Eci, Body>& scenario, const Propagation<Eci, Wheel>& how) {
#endif
  return propagate(scenario, how);
}
