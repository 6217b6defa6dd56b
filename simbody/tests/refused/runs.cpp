// Runs of Simbody
#include <vectrix/simbody.hpp>

#include "../../../dynamics/tests/refused/sat.hpp"

namespace a_run_of_simbody_from_the_state_of_another_craft {
// mistake: Simbody runs the scenario of a satellite from the state of a probe
// expect: a state of the scenario's craft
auto flight(const Sat& sat, const CraftState<Sat>& of_sat, const CraftState<Probe>& of_probe) {
  const SimbodyPropagation how{.end = 60.0 * si::second, .accuracy = 1e-8};
#ifdef REPAIRED
  static_cast<void>(of_probe);
  return propagate_with_simbody(scenario(sat), of_sat, how);
#else
  static_cast<void>(of_sat);
  return propagate_with_simbody(scenario(sat), of_probe, how);
#endif
}
}  // namespace a_run_of_simbody_from_the_state_of_another_craft

namespace a_run_of_simbody_as_of_ours {
// mistake: Simbody is given how ours propagates, with tolerances and a method
// expect: and how: SimbodyPropagation
auto flight(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return propagate_with_simbody(scenario(sat), start, SimbodyPropagation{60.0 * si::second, 1e-8});
#else
  return propagate_with_simbody(scenario(sat), start, CraftPropagation{60.0 * si::second, 1e-8, {}});
#endif
}
}  // namespace a_run_of_simbody_as_of_ours

namespace a_run_of_ours_as_of_simbody {
// mistake: ours is given how Simbody propagates
// expect: and how: CraftPropagation
auto flight(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return propagate(scenario(sat), start, CraftPropagation{60.0 * si::second, 1e-8, {}});
#else
  return propagate(scenario(sat), start, SimbodyPropagation{60.0 * si::second, 1e-8});
#endif
}
}  // namespace a_run_of_ours_as_of_simbody
