// Starts of a craft
#include <vectrix/dynamics/craft/named_state.hpp>

#include "panelled_sat.hpp"

constexpr auto rad = si::radian;
constexpr auto s = si::second;

using AtRest = MovingTransform<Gcrf, Hub>;
const auto rad_s = rad / s;

namespace start_given_twice {
// mistake: one start given twice
// expect: StartIsGivenTwice<Wheel>
auto start(const Sat& sat, const AtRest& X) {
  const auto panel = starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * si::second, X, panel, spins(of<Wheel>, 1.0 * rad_s));
#else
  return state(sat, 0.0 * si::second, X, panel, spins(of<Wheel>, 1.0 * rad_s), spins(of<Wheel>, 2.0 * rad_s));
#endif
}
}  // namespace start_given_twice

namespace start_in_metres {
// mistake: a length as the start of a hinge
// expect: StartIsNotThatOf<.*slider.*hinge
auto start(const Sat& sat, const AtRest& X) {
  const auto wheel = spins(of<Wheel>, 1.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * si::second, X, starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s), wheel);
#else
  return state(sat, 0.0 * si::second, X, starts(of<Panel>, 0.1 * si::metre, 0.0 * (si::metre / si::second)),
               wheel);
#endif
}
}  // namespace start_in_metres

namespace start_of_a_name {
// mistake: a start of the run-time form, with a name, in a craft of types
// expect: IsNoStart<(vectrix::)?NamedStart>
auto start(const Sat& sat, const AtRest& X) {
  const auto wheel = spins(of<Wheel>, 1.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * si::second, X, starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s), wheel);
#else
  return state(sat, 0.0 * si::second, X, starts("Panel", 0.1 * si::radian, 0.0 * rad_s), wheel);
#endif
}
}  // namespace start_of_a_name

namespace state_without_craft {
// mistake: the craft of a state is left out
// expect: IsNoCraft<
auto start(const Sat& sat, const AtRest& X) {
  const auto panel = starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * si::second, X, panel, spins(of<Wheel>, 1.0 * rad_s));
#else
  return static_cast<void>(sat), state(0.0 * si::second, X, panel, spins(of<Wheel>, 1.0 * rad_s));
#endif
}
}  // namespace state_without_craft

namespace start_left_out {
// mistake: a joint without a start: none is zero by default
// expect: StartIsMissing<Panel>
auto start(const Sat& sat, const AtRest& X) {
  const auto wheel = spins(of<Wheel>, 1.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * si::second, X, starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s), wheel);
#else
  return state(sat, 0.0 * si::second, X, wheel);
#endif
}
}  // namespace start_left_out

namespace start_with_its_rate_first {
// mistake: the rate of a hinge before its angle: one error, though the state has no start of the hinge then
// expect: angle and rate
auto start(const Sat& sat, const AtRest& X) {
  const auto wheel = spins(of<Wheel>, 1.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * s, X, starts(of<Panel>, 0.1 * rad, 0.0 * rad_s), wheel);
#else
  return state(sat, 0.0 * s, X, starts(of<Panel>, 0.0 * rad_s, 0.1 * rad), wheel);
#endif
}
}  // namespace start_with_its_rate_first

namespace start_without_its_rate {
// mistake: the start of a hinge without its rate
// expect: angle and rate
auto start(const Sat& sat, const AtRest& X) {
  const auto wheel = spins(of<Wheel>, 1.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * s, X, starts(of<Panel>, 0.1 * rad, 0.0 * rad_s), wheel);
#else
  return state(sat, 0.0 * s, X, starts(of<Panel>, 0.1 * rad), wheel);
#endif
}
}  // namespace start_without_its_rate

namespace start_of_a_named_joint_without_its_rate {
// mistake: the same of a joint with a name
// expect: angle and rate
auto start() {
#ifdef REPAIRED
  return starts("panel", 0.1 * rad, 0.0 * rad_s);
#else
  return starts("panel", 0.1 * rad);
#endif
}
}  // namespace start_of_a_named_joint_without_its_rate

namespace spin_without_its_unit {
// mistake: the speed of a wheel as a bare number
// expect: a speed in rad/s
auto start(const Sat& sat, const AtRest& X) {
  const auto panel = starts(of<Panel>, 0.1 * rad, 0.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * s, X, panel, spins(of<Wheel>, 300.0 * rad_s));
#else
  return state(sat, 0.0 * s, X, panel, spins(of<Wheel>, 300.0));
#endif
}
}  // namespace spin_without_its_unit

namespace state_with_its_time_after_the_motion {
// mistake: the motion of the hub before the time
// expect: state\(craft, t, X_i_from_hub, starts...\)
auto start(const Sat& sat, const AtRest& X) {
  const auto panel = starts(of<Panel>, 0.1 * rad, 0.0 * rad_s);
#ifdef REPAIRED
  return state(sat, 0.0 * s, X, panel, spins(of<Wheel>, 1.0 * rad_s));
#else
  return state(sat, X, 0.0 * s, panel, spins(of<Wheel>, 1.0 * rad_s));
#endif
}
}  // namespace state_with_its_time_after_the_motion
