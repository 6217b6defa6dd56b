// mistake: the scenario of one body with the roots and settings of another
// expect: propagate
// expect: Wheel
// expect: Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
auto flight(const Scenario<Gcrf, Body>& scenario, const Propagation<Gcrf, Body>& how) {
#else
auto flight(const Scenario<Gcrf, Body>& scenario, const Propagation<Gcrf, Wheel>& how) {
#endif
  return propagate(scenario, how);
}
