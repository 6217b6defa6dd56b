#pragma once

#include <algorithm>
#include <concepts>
#include <vectrix/dynamics/analysis/linearise.hpp>
#include <vectrix/dynamics/analysis/steady_state.hpp>

namespace vectrix {

/// The state near a guess in which a craft turns as one rigid body, with the angular velocity of the guess,
/// which is constant in the inertial frame: at rest if it is zero, with a craft in a circular orbit if it is
/// the orbital rate. All speeds of joints and modes are zero, and their accelerations vanish; so does that of
/// the hub in its own axes. A free hub moves about the inertial origin, v = w x r. Rotors keep their speeds,
/// and locked joints their places. What no acceleration depends on stays as in the guess; in a family of
/// equilibria it is one near the guess, as each step is the shortest: a joint without a spring moves a little
/// if others are not yet at rest. Found by KINSOL, Newton's method with line search, with exact derivatives;
/// each acceleration that is left is below its tolerance. Throws BadInput for a tolerance that is not
/// positive and a guess whose accelerations are not finite, NoEquilibrium if none is found.
template <CraftType C, class... Parts>
  requires(std::is_same_v<
           detail::FaultOfLinear<C, C, CraftScenario<C, Parts...>, CraftInputs<>, CraftOutputs<>>, Nothing>)
CraftState<C> equilibrium(const CraftScenario<C, Parts...>& scenario, const CraftState<C>& guess,
                          const EquilibriumTolerances& tolerances) {
  const auto start = detail::start_of_run("equilibrium", scenario, guess);
  const detail::CraftCore& core = *scenario.craft().core();
  auto rates = detail::dual_rates<C>(detail::in_duals(core), detail::held_loads(scenario.parts(), start.held),
                                     detail::InputLoad<C, Dual>{nullptr});
  const double t = guess.time().value();
  const auto y =
      detail::steady_state({core, start.y, [&](const Dual* state, Dual* ydot) { rates(t, state, ydot); },
                            rates.work(), tolerances});
  typename CraftState<C>::Numbers numbers{};
  std::copy(y.begin(), y.end(), numbers.begin());
  return {detail::trusted, guess.time(), numbers};
}

template <class Scenario, class State,
          class Fault =
              typename detail::FaultOfArguments<Scenario, State, CraftInputs<>, CraftOutputs<>>::type>
  requires(!std::is_same_v<Fault, Nothing>)
auto equilibrium(  // a scenario and a state of its craft; loads of any scalar: see Fault
    const Scenario&, const State&, const EquilibriumTolerances&) -> Refused = delete;

}  // namespace vectrix
