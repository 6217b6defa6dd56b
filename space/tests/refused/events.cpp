// Events
#include <vectrix/space.hpp>

using namespace vectrix;

namespace events_of_a_condition {
// mistake: the zeros of a condition, which has none: whether the satellite is above the horizon
// expect: gives a double or a quantity, not a bool
auto rises(const TimeSpan& span, Quantity<si::angle> (*elevation)(const Epoch&)) {
#ifdef REPAIRED
  return events(span, 30.0 * si::second, elevation);
#else
  return events(span, 30.0 * si::second,
                [elevation](const Epoch& t) { return elevation(t) > 0.0 * si::radian; });
#endif
}
}  // namespace events_of_a_condition

namespace intervals_of_a_function_of_seconds {
// mistake: the intervals of an epoch's span, of a function of seconds
// expect: f: of an Epoch
auto passes(const TimeSpan& span, double (*height)(Quantity<si::time>)) {
#ifdef REPAIRED
  return intervals(span, 30.0 * si::second, [&](const Epoch& t) { return height(t - span.start()); });
#else
  return intervals(span, 30.0 * si::second, height);
#endif
}
}  // namespace intervals_of_a_function_of_seconds

namespace events_with_a_step_in_minutes {
// mistake: a step in minutes, which is not converted
// expect: minute
// expect: step in s
auto crossings(const TimeSpan& span, double (*height)(const Epoch&)) {
#ifdef REPAIRED
  return events(span, convert<si::time>(2.0 * si::minute), height);
#else
  return events(span, 2.0 * si::minute, height);
#endif
}
}  // namespace events_with_a_step_in_minutes
