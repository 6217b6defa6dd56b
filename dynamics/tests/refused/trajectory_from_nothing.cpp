// mistake: a trajectory that no propagation made
// expect: Trajectory<Gcrf, Body>
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto flight(const Scenario<Gcrf, Body>& scenario, const Propagation<Gcrf, Body>& how) {
#ifdef REPAIRED
  const Trajectory<Gcrf, Body> trajectory = propagate(scenario, how);
#else
  static_cast<void>(scenario);
  static_cast<void>(how);
  const Trajectory<Gcrf, Body> trajectory;
#endif
  return trajectory;
}
