// mistake: a trajectory that no propagation made
// expect: Trajectory<Eci, Body>
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto flight(const Scenario<Eci, Body>& scenario, const Propagation<Eci, Body>& how) {
#ifdef REPAIRED
  const Trajectory<Eci, Body> trajectory = propagate(scenario, how);
#else
  static_cast<void>(scenario);
  static_cast<void>(how);
  const Trajectory<Eci, Body> trajectory;
#endif
  return trajectory;
}
