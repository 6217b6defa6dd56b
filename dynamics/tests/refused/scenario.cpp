// Scenario and trajectory
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Eci : inertial_frame {};
struct Ecef : moving_frame {};
struct Body : moving_frame {};
struct Wheel : moving_frame {};

namespace propagation_of_other_body {
// mistake: the scenario of one body with the roots and settings of another
// expect: propagate
// expect: Wheel
// expect: Body
#ifdef REPAIRED
auto flight(const Scenario<Eci, Body>& scenario, const Propagation<Eci, Body>& how) {
#else
auto flight(const Scenario<Eci, Body>& scenario, const Propagation<Eci, Wheel>& how) {
#endif
  return propagate(scenario, how);
}
}  // namespace propagation_of_other_body

namespace propagation_until_minutes {
// mistake: a time in minutes where seconds are meant; convert<si::time>() says so
// expect: (minute|scale<60)
// expect: time
auto quarter_hour() {
  Propagation<Eci, Body> how;
#ifdef REPAIRED
  how.end = convert<si::time>(15.0 * si::minute);
#else
  how.end = 15.0 * si::minute;
#endif
  return how;
}
}  // namespace propagation_until_minutes

namespace scenario_of_two_bodies {
// mistake: the scenario of one body with the initial state of another
// expect: State<.*, Wheel>
// expect: State<.*, Body>
#ifdef REPAIRED
auto start(Scenario<Eci, Body> scenario, const State<Eci, Body>& state) {
#else
auto start(Scenario<Eci, Body> scenario, const State<Eci, Wheel>& state) {
#endif
  scenario.initial = state;
  return scenario;
}
}  // namespace scenario_of_two_bodies

namespace state_relative_to_moving_frame {
// mistake: a state relative to the rotating Earth
// expect: InertialFrame
// expect: Ecef
#ifdef REPAIRED
double start(const State<Eci, Body>& state);
#else
double start(const State<Ecef, Body>& state);
#endif
}  // namespace state_relative_to_moving_frame

namespace trajectory_edited {
// mistake: a trajectory edited after the run
// expect: steps
// expect: (temporary as lvalue|rvalue as lvalue|not assignable)
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
}  // namespace trajectory_edited

namespace trajectory_from_nothing {
// mistake: a trajectory that no propagation made
// expect: Trajectory<Eci, Body>
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
}  // namespace trajectory_from_nothing
