// mistake: a trajectory edited after the run
// expect: steps
// expect: (temporary as lvalue|rvalue as lvalue|not assignable)
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto cheaper(Trajectory<Eci, Body>& trajectory) {
#ifdef REPAIRED
  ode::Statistics statistics = trajectory.statistics();
  statistics.steps = 1;
  return statistics;
#else
  trajectory.statistics().steps = 1;
  return trajectory.statistics();
#endif
}
