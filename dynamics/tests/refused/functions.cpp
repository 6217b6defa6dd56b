// Functions of a scenario
#include "panelled_sat.hpp"

constexpr auto N_m = si::newton_metre;
constexpr auto rad = si::radian;
constexpr auto s = si::second;

// A function whose body has an error has no result. That error is said, and the scenario does not refuse the
// function once more.

namespace event_of_a_number {
// mistake: a number without its unit in the function of an event
// expect: a number needs its unit
auto flight(const Sat& sat) {
  const auto angle = [](const Now<Sat>& now) {
#ifdef REPAIRED
    return now.coordinate(of<Panel>) - 0.5 * rad;
#else
    return now.coordinate(of<Panel>) - 0.5;
#endif
  };
  return scenario(sat, when("open", angle, ode::Direction::rising));
}
}  // namespace event_of_a_number

namespace event_of_an_angle_and_a_length {
// mistake: a length from an angle in the function of an event
// expect: another unit
auto flight(const Sat& sat) {
  const auto angle = [](const Now<Sat>& now) {
#ifdef REPAIRED
    return now.coordinate(of<Panel>) - 0.5 * rad;
#else
    return now.coordinate(of<Panel>) - 0.5 * si::metre;
#endif
  };
  return scenario(sat, when("open", angle, ode::Direction::rising));
}
}  // namespace event_of_an_angle_and_a_length

namespace controller_with_a_bare_gain {
// mistake: the gain of a controller without its unit
// expect: [Qq]uantity
struct Command {
  Quantity<si::torque> torque;
};
auto flight(const Sat& sat) {
  const auto control = [](const Now<Sat>& now) {
#ifdef REPAIRED
    return Command{-2.0 * (N_m / rad) * now.coordinate(of<Panel>)};
#else
    return Command{-2.0 * now.coordinate(of<Panel>)};
#endif
  };
  return scenario(sat, held(Command{0.0 * N_m}), every(0.1 * s, control));
}
}  // namespace controller_with_a_bare_gain

namespace event_that_returns_nothing {
// mistake: the function of an event returns nothing, which is no error in it
// expect: IsNoFunctionOfTheState<
auto flight(const Sat& sat) {
#ifdef REPAIRED
  const auto angle = [](const Now<Sat>& now) { return now.coordinate(of<Panel>); };
#else
  const auto angle = [](const Now<Sat>& now) { now.coordinate(of<Panel>); };
#endif
  return scenario(sat, when("open", angle, ode::Direction::rising));
}
}  // namespace event_that_returns_nothing

namespace event_of_too_much {
// mistake: a generic function of an event takes one argument too many
// expect: IsNoFunctionOfTheState<
auto flight(const Sat& sat) {
#ifdef REPAIRED
  const auto angle = [](const auto& now) { return now.coordinate(of<Panel>); };
#else
  const auto angle = [](const auto& now, const auto&) { return now.coordinate(of<Panel>); };
#endif
  return scenario(sat, when("open", angle, ode::Direction::rising));
}
}  // namespace event_of_too_much

namespace load_without_the_state {
// mistake: a load that takes the forces alone
// expect: IsNoLoad<
auto flight(const Sat& sat) {
#ifdef REPAIRED
  return scenario(sat, [](const Now<Sat>&, Forces<Sat>& forces) { forces.motor(of<Wheel>, 0.1 * N_m); });
#else
  return scenario(sat, [](Forces<Sat>& forces) { forces.motor(of<Wheel>, 0.1 * N_m); });
#endif
}
}  // namespace load_without_the_state

namespace load_of_the_time {
// mistake: a load that takes the time in place of the state
// expect: a load is a function of const Now<C>& and Forces<C>&
auto accelerations(const Sat& sat, const CraftState<Sat>& now) {
#ifdef REPAIRED
  return motion(sat, now, [](const Now<Sat>&, Forces<Sat>& forces) { forces.motor(of<Wheel>, 0.1 * N_m); });
#else
  return motion(sat, now,
                [](Quantity<si::time>, Forces<Sat>& forces) { forces.motor(of<Wheel>, 0.1 * N_m); });
#endif
}
}  // namespace load_of_the_time

namespace run_of_a_craft {
// mistake: the run of a craft in place of its scenario
// expect: scenario\(craft, ...\), a state of its craft
auto run(const Sat& sat, const CraftState<Sat>& start, const CraftPropagation& how) {
#ifdef REPAIRED
  return propagate(scenario(sat), start, how);
#else
  return propagate(sat, start, how);
#endif
}
}  // namespace run_of_a_craft

namespace period_as_a_frequency {
// mistake: the frequency of a controller in place of its period
// expect: every\(period, f, latency\)
struct Mode {
  bool on;
};
auto tick() {
#ifdef REPAIRED
  return every(0.1 * s, becomes(Mode{true}));
#else
  return every(10.0 / s, becomes(Mode{true}));
#endif
}
}  // namespace period_as_a_frequency
