#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/simbody/engine.hpp>

namespace vectrix {

using detail::SimbodyPair;

/// How Simbody propagates a craft, until `end`. Its estimate of the error of a step is at most `accuracy` in
/// each number: rad, m, rad per `time_scale`, m per `time_scale`. Of a speed it is relative where the speed
/// is larger than one of these units, and of the hub's place where that is farther than 1 m from the inertial
/// origin. There is no default of the accuracy; Simbody's own, 1e-3, compares nothing.
struct SimbodyPropagation {
  Quantity<si::time> end;
  double accuracy;
  SimbodyPair pair = SimbodyPair::merson;
  Quantity<si::time> time_scale = 1.0 * si::second;
  Quantity<si::time> maximum_step = std::numeric_limits<double>::infinity() * si::second;
  std::size_t max_steps = 10'000'000;
  std::vector<Quantity<si::time>> output_times{detail::no_list<Quantity<si::time>>()};
};

namespace detail {

/// What acts at (t, y), as CraftRates::loads() gives it.
using LoadsFound = std::function<const multibody::Work<double>&(double t, const double* y)>;

VECTRIX_EXPORT SimbodyCraft simbody_craft(const PlainSpacecraft& craft);
VECTRIX_EXPORT void copy_loads(const multibody::Work<double>& found, SimbodyLoads& loads);
/// Integrates a problem of a craft, whose quaternions become unit ones, by Simbody's integrator.
VECTRIX_EXPORT ode::Solution solve_with_simbody(const PlainSpacecraft& craft, ode::Problem problem,
                                                const SimbodyPropagation& how, const LoadsFound& loads);

}  // namespace detail

/// The motion of the craft of a scenario from a state on, by Simbody: its equations of motion, integrated by
/// it from each change to the next. The loads are those of the scenario; held values, their changes, the
/// search for zeros and the record are as in propagate(), and so is the trajectory. Its dense output goes
/// through the states and rates at Simbody's own steps. Throws BadInput if a number is not what it must be,
/// or Simbody refuses a body that is too flat to hold its rotors, and CraftFailure, as propagate() does.
template <CraftType C, class... Parts>
typename detail::TrajectoryOf<C, detail::HeldTypes<Parts...>>::type propagate_with_simbody(
    const CraftScenario<C, Parts...>& scenario, const CraftState<C>& start, const SimbodyPropagation& how) {
  const auto solve = [&](ode::Problem& run, detail::Flight<C, Parts...>& flight) {
    return detail::solve_with_simbody(
        scenario.craft().core()->plain, std::move(run), how,
        [&](double t, const double* y) -> const multibody::Work<double>& { return flight.loads(t, y); });
  };
  return detail::fly("propagate_with_simbody", scenario, start, how, {}, solve);
}

template <CraftType C, class... Parts, CraftType GivenC, class How = SimbodyPropagation>
  requires(!std::is_same_v<C, GivenC> || !std::is_same_v<How, SimbodyPropagation>)
auto propagate_with_simbody(  // a state of the scenario's craft, and how: SimbodyPropagation
    const CraftScenario<C, Parts...>&, const CraftState<GivenC>&, const How&) -> Refused = delete;

}  // namespace vectrix
