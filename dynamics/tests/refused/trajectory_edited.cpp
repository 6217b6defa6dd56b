// mistake: a trajectory edited after the run
// expect: steps
// expect: (read-only object|const-qualified type)
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto cheaper(Trajectory<Gcrf, Body>& trajectory) {
#ifdef REPAIRED
  ode::Statistics statistics = trajectory.statistics();
  statistics.steps = 1;
  return statistics;
#else
  trajectory.statistics().steps = 1;
  return trajectory.statistics();
#endif
}
