// Comparison of two trajectories
#include "sat.hpp"

namespace a_trajectory_of_another_craft {
// mistake: the flight of a satellite compared with that of a probe
// expect: two trajectories of the craft C
auto table(const Sat& sat, const CraftTrajectory<Sat>& ours, const CraftTrajectory<Sat>& theirs,
           const CraftTrajectory<Probe>& of_probe) {
#ifdef REPAIRED
  static_cast<void>(of_probe);
  return compare(sat, ours, theirs);
#else
  static_cast<void>(theirs);
  return compare(sat, ours, of_probe);
#endif
}
}  // namespace a_trajectory_of_another_craft

namespace trajectories_of_another_craft {
// mistake: two flights of a satellite compared as if they were those of a probe
// expect: two trajectories of the craft C
auto table(const Sat& sat, const Probe& probe, const CraftTrajectory<Sat>& ours,
           const CraftTrajectory<Sat>& theirs) {
#ifdef REPAIRED
  static_cast<void>(probe);
  return compare(sat, ours, theirs);
#else
  static_cast<void>(sat);
  return compare(probe, ours, theirs);
#endif
}
}  // namespace trajectories_of_another_craft

namespace difference_of_the_place_of_a_turning_hub {
// mistake: the difference of the position of a hub that only turns
// expect: of a hub that is free_in<I>
auto size(const CraftComparison<Sat>& found) {
#ifdef REPAIRED
  return found.attitude(of<Hub>);
#else
  return found.position(of<Hub>);
#endif
}
}  // namespace difference_of_the_place_of_a_turning_hub

namespace difference_of_a_body_beside_the_craft {
// mistake: the difference of the attitude of a dish that the craft does not have
// expect: of the hub, or of a body of the craft C on a ball joint or a free one
auto size(const CraftComparison<Sat>& found) {
#ifdef REPAIRED
  return found.attitude(of<Hub>);
#else
  return found.attitude(of<Dish>);
#endif
}
}  // namespace difference_of_a_body_beside_the_craft

namespace difference_of_the_spin_of_the_hub {
// mistake: the difference of the spin of the hub; only rotors have one
// expect: of a rotor of the craft C
auto size(const CraftComparison<Sat>& found) {
#ifdef REPAIRED
  return found.spin(of<Wheel>);
#else
  return found.spin(of<Hub>);
#endif
}
}  // namespace difference_of_the_spin_of_the_hub
