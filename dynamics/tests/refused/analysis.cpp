// Linear systems and equilibria of a craft
#include "sat.hpp"

const auto torque = 0.1 * si::newton_metre * unit_z(in<Hub>);

namespace a_load_of_doubles {
// mistake: a load that takes no numbers with derivatives
// expect: TakesNoDuals<
auto system(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  const auto load = []<class S>(const Now<Sat, S>&, Forces<Sat, S>& forces) {
    forces.torque(of<Hub>, torque);
  };
#else
  const auto load = [](const Now<Sat>&, Forces<Sat>& forces) { forces.torque(of<Hub>, torque); };
#endif
  return linearise(scenario(sat, load), start);
}
}  // namespace a_load_of_doubles

namespace an_equilibrium_with_a_load_of_doubles {
// mistake: the same in an equilibrium
// expect: TakesNoDuals<
auto rest(const Sat& sat, const CraftState<Sat>& guess, const EquilibriumTolerances& fine) {
#ifdef REPAIRED
  const auto load = [](const auto&, auto& forces) { forces.torque(of<Hub>, torque); };
#else
  const auto load = [](const Now<Sat>&, Forces<Sat>& forces) { forces.torque(of<Hub>, torque); };
#endif
  return equilibrium(scenario(sat, load), guess, fine);
}
}  // namespace an_equilibrium_with_a_load_of_doubles

namespace an_input_beside_the_craft {
// mistake: a torque on a dish that the craft does not have
// expect: NoInputOfTheCraft<(vectrix::)?TorqueInput<Dish, Hub>
auto system(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return linearise(scenario(sat), start, inputs(torque_input(of<Hub>, in<Hub>)));
#else
  return linearise(scenario(sat), start, inputs(torque_input(of<Dish>, in<Hub>)));
#endif
}
}  // namespace an_input_beside_the_craft

namespace an_input_without_inputs {
// mistake: an input that is not in inputs()
// expect: AreNoInputs<(vectrix::)?MotorInput<Wheel>
auto system(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return linearise(scenario(sat), start, inputs(motor_input(of<Wheel>)));
#else
  return linearise(scenario(sat), start, motor_input(of<Wheel>));
#endif
}
}  // namespace an_input_without_inputs

namespace a_linearisation_without_state {
// mistake: the state about which to linearise is left out
// expect: IsNoState<
auto system(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return linearise(scenario(sat), start);
#else
  return static_cast<void>(start), linearise(scenario(sat));
#endif
}
}  // namespace a_linearisation_without_state

namespace a_linearisation_of_a_craft {
// mistake: a craft for its scenario
// expect: IsNoScenario<Sat
auto system(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return linearise(scenario(sat), start);
#else
  return linearise(sat, start);
#endif
}
}  // namespace a_linearisation_of_a_craft

namespace an_input_twice {
// mistake: one motor as two inputs
// expect: InputIsGivenTwice<(vectrix::)?MotorInput<Wheel>
auto system(const Sat& sat, const CraftState<Sat>& start) {
#ifdef REPAIRED
  return linearise(scenario(sat), start, inputs(motor_input(of<Wheel>)));
#else
  return linearise(scenario(sat), start, inputs(motor_input(of<Wheel>), motor_input(of<Wheel>)));
#endif
}
}  // namespace an_input_twice

namespace an_output_of_no_number {
// mistake: a rotation as an output; its rotation vector has three numbers
// expect: GivesNoNumberOrVector<
auto system(const Sat& sat, const CraftState<Sat>& start) {
  const auto turn = [](const auto& motion) {
#ifdef REPAIRED
    return log(motion.now().rotation(to<Gcrf>, from<Hub>));
#else
    return motion.now().rotation(to<Gcrf>, from<Hub>);
#endif
  };
  return linearise(scenario(sat), start, inputs(), outputs(output("attitude", turn)));
}
}  // namespace an_output_of_no_number

namespace a_state_of_another_craft {
// mistake: the state of a probe in the scenario of a satellite
// expect: IsAStateOf<Probe>
auto system(const Sat& sat, const CraftState<Sat>& of_sat, const CraftState<Probe>& of_probe) {
#ifdef REPAIRED
  static_cast<void>(of_probe);
  return linearise(scenario(sat), of_sat);
#else
  static_cast<void>(of_sat);
  return linearise(scenario(sat), of_probe);
#endif
}
}  // namespace a_state_of_another_craft

namespace a_row_of_no_rotor {
// mistake: the spin of the hub; only rotors have one
// expect: of a rotor of the craft
auto number(const Sat& sat, const CraftState<Sat>& start) {
  const auto system = linearise(scenario(sat), start);
#ifdef REPAIRED
  return system.A(system.spin(of<Wheel>), 0);
#else
  return system.A(system.spin(of<Hub>), 0);
#endif
}
}  // namespace a_row_of_no_rotor
