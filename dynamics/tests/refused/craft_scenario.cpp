// Scenarios of a craft
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};

auto make_sat() {
  return spacecraft(
      body(mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                           trust_inertia(in<Hub>, Eigen::Matrix3d::Identity())),
           turning_in<Gcrf>));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};
struct Probe : decltype(make_sat()) {
  Probe() : decltype(make_sat())(make_sat()) {}
};

struct Command {
  Quantity<si::torque> torque;
};
struct Mode {
  int number;
};
const Command none{0.0 * si::newton_metre};
const auto by_command = [](const Now<Sat>&, Forces<Sat>& forces, const Command& command) {
  forces.torque(of<Hub>, command.torque * unit_z(in<Hub>));
};

namespace a_load_takes_what_nothing_holds {
// mistake: a load takes a command, and the scenario holds none
// expect: NothingHolds<Command>
auto flight(const Sat& sat) {
#ifdef REPAIRED
  return scenario(sat, by_command, held(none));
#else
  return scenario(sat, by_command);
#endif
}
}  // namespace a_load_takes_what_nothing_holds

namespace a_result_of_another_type {
// mistake: a controller returns a torque; what is held is a command
// expect: NothingHolds<(vectrix::)?Quantity<(vectrix::)?si::torque
const auto feedback = [](const Now<Sat>&) {
#ifdef REPAIRED
  return Command{1.0 * si::newton_metre};
#else
  return 1.0 * si::newton_metre;
#endif
};
auto flight(const Sat& sat) {
  return scenario(sat, by_command, held(none), every(0.1 * si::second, feedback));
}
}  // namespace a_result_of_another_type

namespace held_twice {
// mistake: a type is held twice
// expect: IsHeldTwice<Mode>
auto flight(const Sat& sat) {
#ifdef REPAIRED
  return scenario(sat, held(Mode{1}), held(none));
#else
  return scenario(sat, held(Mode{1}), held(Mode{2}));
#endif
}
}  // namespace held_twice

namespace a_load_of_another_craft {
// mistake: a load on a probe in the scenario of a satellite
// expect: IsNoLoad<
auto flight(const Sat& sat) {
#ifdef REPAIRED
  return scenario(sat, [](const Now<Sat>&, Forces<Sat>&) {});
#else
  return scenario(sat, [](const Now<Probe>&, Forces<Probe>&) {});
#endif
}
}  // namespace a_load_of_another_craft

namespace a_zero_of_a_vector {
// mistake: the zeros of a vector
// expect: IsNoFunctionOfTheState<
const auto rate = [](const Now<Sat>& now) {
  const auto w = now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>);
#ifdef REPAIRED
  return w.z();
#else
  return w;
#endif
};
auto flight(const Sat& sat) {
  return scenario(sat, when("at rest", rate, ode::Direction::any));
}
}  // namespace a_zero_of_a_vector

namespace a_zero_without_a_direction {
// mistake: an event that ends the run, without the direction of its zeros
// expect: when\("name", g, ode::Direction::falling\)
const auto rate = [](const Now<Sat>& now) {
  return now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>).z();
};
auto flight(const Sat& sat) {
#ifdef REPAIRED
  return scenario(sat, when("at rest", rate, ode::Direction::any, stop));
#else
  return scenario(sat, when("at rest", rate, stop));
#endif
}
}  // namespace a_zero_without_a_direction

namespace a_zero_of_a_condition {
// mistake: the zeros of a condition, which has none: it jumps
// expect: IsNoFunctionOfTheState<
const auto too_fast = [](const Now<Sat>& now) {
  const auto w = now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>);
#ifdef REPAIRED
  return w.z() - 0.1 * (si::radian / si::second);
#else
  return w.z() > 0.1 * (si::radian / si::second);
#endif
};
auto flight(const Sat& sat) {
  return scenario(sat, when("too fast", too_fast, ode::Direction::rising));
}
}  // namespace a_zero_of_a_condition

namespace a_held_value_of_another_scenario {
// mistake: a trajectory is asked for a value that its scenario does not hold
// expect: a type that the scenario holds
auto value(const CraftTrajectory<Sat, Command>& flight) {
#ifdef REPAIRED
  return flight.held<Command>(1.0 * si::second);
#else
  return flight.held<Mode>(1.0 * si::second);
#endif
}
}  // namespace a_held_value_of_another_scenario

namespace a_motion_of_another_trajectory {
// mistake: the trajectory of a scenario that holds a mode, and the scenario holds a command
// expect: CraftTrajectory<GivenC, X\.\.\.>|a trajectory of the scenario
auto alpha(const Sat& sat, const CraftTrajectory<Sat, Command>& commanded,
           const CraftTrajectory<Sat, Mode>& in_modes) {
  const auto flight = scenario(sat, by_command, held(none));
#ifdef REPAIRED
  return static_cast<void>(in_modes), motion_at(flight, commanded, 1.0 * si::second);
#else
  return static_cast<void>(commanded), motion_at(flight, in_modes, 1.0 * si::second);
#endif
}
}  // namespace a_motion_of_another_trajectory

namespace a_period_without_unit {
// mistake: a period without its unit
// expect: every
auto change() {
#ifdef REPAIRED
  return every(0.1 * si::second, becomes(none));
#else
  return every(0.1, becomes(none));
#endif
}
}  // namespace a_period_without_unit

namespace the_period_after_the_function {
// mistake: the period of a controller after its function
// expect: every
auto change() {
#ifdef REPAIRED
  return every(0.1 * si::second, becomes(none));
#else
  return every(becomes(none), 0.1 * si::second);
#endif
}
}  // namespace the_period_after_the_function

namespace a_scenario_without_craft {
// mistake: the craft of a scenario is left out
// expect: IsNoCraft<
auto flight(const Sat& sat) {
#ifdef REPAIRED
  return scenario(sat, by_command, held(none));
#else
  return static_cast<void>(sat), scenario(by_command, held(none));
#endif
}
}  // namespace a_scenario_without_craft

namespace a_generic_controller {
// mistake: a controller whose argument has no type: what it takes cannot be known
// expect: IsNoChange<
#ifdef REPAIRED
const auto feedback = [](const Now<Sat>&) { return none; };
#else
const auto feedback = [](const auto&) { return none; };
#endif
auto flight(const Sat& sat) {
  return scenario(sat, held(none), every(0.1 * si::second, feedback));
}
}  // namespace a_generic_controller

namespace one_time_without_braces {
// mistake: one time where a list of times is due
// expect: at_times\(\{t, \.\.\.\}, f\)
auto change() {
#ifdef REPAIRED
  return at_times({1.0 * si::second}, becomes(none));
#else
  return at_times(1.0 * si::second, becomes(none));
#endif
}
}  // namespace one_time_without_braces

namespace a_start_of_another_craft {
// mistake: the scenario of one craft with the state of another
// expect: propagate
// expect: a state of its craft
auto fly(const Sat& sat, const CraftState<Sat>& start, const CraftState<Probe>& other,
         const CraftPropagation& how) {
#ifdef REPAIRED
  return static_cast<void>(other), propagate(scenario(sat), start, how);
#else
  return static_cast<void>(start), propagate(scenario(sat), other, how);
#endif
}
}  // namespace a_start_of_another_craft

namespace a_start_of_another_body {
// mistake: a craft starts with the motion of another body
// expect: HubMovesWith<.*MovingDcm<Gcrf, Panel.*MovingDcm<Gcrf, Hub
struct Panel : moving_frame {};
auto start(const Sat& sat, const MovingDcm<Gcrf, Hub>& R_i_from_hub,
           const MovingDcm<Gcrf, Panel>& R_i_from_panel) {
#ifdef REPAIRED
  return static_cast<void>(R_i_from_panel), state(sat, 0.0 * si::second, R_i_from_hub);
#else
  return static_cast<void>(R_i_from_hub), state(sat, 0.0 * si::second, R_i_from_panel);
#endif
}
}  // namespace a_start_of_another_body

namespace a_load_that_returns_its_torque {
// mistake: a load returns its torque instead of putting it on a body
// expect: IsNoLoad<
auto solar_pressure(const Sat& sat, const Vector<Gcrf, si::torque>& torque_eci) {
#ifdef REPAIRED
  return scenario(sat, [=](const Now<Sat>&, Forces<Sat>& forces) { forces.torque(of<Hub>, torque_eci); });
#else
  return scenario(sat, [=](const Now<Sat>&) { return torque_eci; });
#endif
}
}  // namespace a_load_that_returns_its_torque

namespace a_run_until_minutes {
// mistake: a time in minutes where seconds are meant; convert<si::time>() says so
// expect: (minute|scale<60)
// expect: time
auto quarter_hour(CraftPropagation how) {
#ifdef REPAIRED
  how.end = convert<si::time>(15.0 * si::minute);
#else
  how.end = 15.0 * si::minute;
#endif
  return how;
}
}  // namespace a_run_until_minutes

namespace a_hub_in_a_moving_frame {
// mistake: a craft that turns relative to the rotating Earth
// expect: InertialFrame
// expect: Ecef
struct Ecef : moving_frame {};
auto make(const MassProperties<Hub, Hub, In<Hub>>& mass) {
#ifdef REPAIRED
  return body(mass, turning_in<Gcrf>);
#else
  return body(mass, turning_in<Ecef>);
#endif
}
}  // namespace a_hub_in_a_moving_frame

namespace a_trajectory_edited {
// mistake: a trajectory edited after the run
// expect: steps
// expect: (temporary as lvalue|rvalue as lvalue|not assignable)
auto cheaper(CraftTrajectory<Sat>& flight) {
#ifdef REPAIRED
  ode::Statistics statistics = flight.solution().statistics();
  statistics.steps = 1;
  return statistics;
#else
  flight.solution().statistics().steps = 1;
  return flight.solution().statistics();
#endif
}
}  // namespace a_trajectory_edited

namespace a_trajectory_from_nothing {
// mistake: a trajectory that no propagation made
// expect: CraftTrajectory
auto fly(const Sat& sat, const CraftState<Sat>& start, const CraftPropagation& how) {
#ifdef REPAIRED
  const CraftTrajectory<Sat> flight = propagate(scenario(sat), start, how);
#else
  static_cast<void>(sat), static_cast<void>(start), static_cast<void>(how);
  const CraftTrajectory<Sat> flight;
#endif
  return flight;
}
}  // namespace a_trajectory_from_nothing

namespace conservation_in_another_scenario {
// mistake: the conservation report of the trajectory of another craft
// expect: both of one craft
auto report(const Sat& sat, const CraftTrajectory<Sat>& flight, const CraftTrajectory<Probe>& other) {
#ifdef REPAIRED
  return static_cast<void>(other), conservation(scenario(sat), flight);
#else
  return static_cast<void>(flight), conservation(scenario(sat), other);
#endif
}
}  // namespace conservation_in_another_scenario

namespace the_change_of_an_attitude {
// mistake: the largest change of an attitude, which is no vector
// expect: a number, quantity or vector
auto change(const Sat& sat, const CraftTrajectory<Sat>& flight) {
#ifdef REPAIRED
  return largest_change(sat, flight, [](const Now<Sat>& now) { return now.angular_momentum(); });
#else
  return largest_change(sat, flight, [](const Now<Sat>& now) { return now.rotation(to<Gcrf>, from<Hub>); });
#endif
}
}  // namespace the_change_of_an_attitude

namespace a_change_that_gives_nothing {
// mistake: what a zero changes is not returned
// expect: IsNoChange
auto flight(const Sat& sat) {
  const auto w = [](const Now<Sat>& now) {
    return now.angular_velocity(of<Hub>, relative_to<Gcrf>, in<Hub>).x();
  };
  Command next = none;
#ifdef REPAIRED
  const auto update = [=](const Now<Sat>&) { return next; };
#else
  const auto update = [&](const Now<Sat>&) { next = none; };
#endif
  return scenario(sat, by_command, held(none), when("turns over", w, ode::Direction::any, update));
}
}  // namespace a_change_that_gives_nothing
