#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>
#include <vectrix/dynamics/analysis/errors_of_state.hpp>
#include <vectrix/dynamics/analysis/linear_system.hpp>
#include <vectrix/dynamics/analysis/outputs.hpp>
#include <vectrix/dynamics/craft/flight.hpp>

namespace vectrix {

// A load that is not for any scalar, for messages: []<class S>(const Now<C, S>&, Forces<C, S>&), or a generic
// function.
template <class Load> struct TakesNoDuals {};
template <class GivenC> struct IsAStateOf {};
// What stands where a scenario, its state, inputs() or outputs() should; Nothing if it is left out.
template <class Given> struct IsNoScenario {};
template <class Given> struct IsNoState {};
template <class Given> struct AreNoInputs {};
template <class Given> struct AreNoOutputs {};

namespace detail {

/// A state as it is when a run starts from it, and what the run then holds. Throws BadInput if its rates are
/// not finite, with the load that makes them so.
template <CraftType C, class HeldTuple> struct StartOfRun {
  std::array<double, C::state_size> y;
  HeldTuple held;
};
template <CraftType C, class... Parts>
StartOfRun<C, HeldTypes<Parts...>> start_of_run(const char* action,
                                                const CraftScenario<C, Parts...>& scenario,
                                                const CraftState<C>& state) {
  const double t = state.time().value();
  Flight<C, Parts...> flight(scenario, t, t + std::max(16.0 * same_instant(t, t), 1e-300));
  auto y = state.numbers();
  flight.change(t, y, {});
  std::array<double, C::state_size> ydot{};
  flight.rates(t, y.data(), ydot.data());
  const auto why = [&] { return flight.not_finite(t, y.data()); };
  require_finite_rates(*scenario.craft().core(), action, t, ydot, std::ref(why));
  return {y, flight.values()};
}

template <class C, class Part> constexpr bool takes_duals() {
  if constexpr (PartOf<Part>::load)
    return CallableWith<Part, std::tuple<const Now<C, Dual>&, Forces<C, Dual>&>, TakenByLoad<C, Part>>::value;
  else
    return true;
}
template <class C, class... Parts> constexpr auto fault_of_loads() {
  constexpr std::size_t bad = first_of<!takes_duals<C, Parts>()...>();
  if constexpr (bad != nowhere)
    return std::type_identity<TakesNoDuals<std::tuple_element_t<bad, std::tuple<Parts...>>>>{};
  else
    return std::type_identity<Nothing>{};
}
template <class C, class Scenario, class Inputs, class Outputs> struct LinearFault;
template <class C, class... Parts, class... Input, class... F>
struct LinearFault<C, CraftScenario<C, Parts...>, CraftInputs<Input...>, CraftOutputs<F...>> {
  static constexpr auto fault() {
    using OfLoads = typename decltype(fault_of_loads<C, Parts...>())::type;
    using OfInputs = typename decltype(fault_of_inputs<C, Input...>())::type;
    if constexpr (!std::is_same_v<OfLoads, Nothing>)
      return std::type_identity<OfLoads>{};
    else if constexpr (!std::is_same_v<OfInputs, Nothing>)
      return std::type_identity<OfInputs>{};
    else
      return fault_of_outputs<C, F...>();
  }
  using type = typename decltype(fault())::type;
};

template <class C, class GivenC, class Scenario, class Inputs, class Outputs>
using FaultOfLinear =
    typename std::conditional_t<std::is_same_v<C, GivenC>, LinearFault<C, Scenario, Inputs, Outputs>,
                                std::type_identity<IsAStateOf<GivenC>>>::type;

/// The first mistake in all arguments.
template <class Scenario, class State, class Inputs, class Outputs>
struct FaultOfArguments : std::type_identity<IsNoScenario<Scenario>> {};
template <class C, class... Parts, class State, class Inputs, class Outputs>
struct FaultOfArguments<CraftScenario<C, Parts...>, State, Inputs, Outputs>
    : std::type_identity<IsNoState<State>> {};
template <class C, class... Parts, class GivenC, class Inputs, class Outputs>
struct FaultOfArguments<CraftScenario<C, Parts...>, CraftState<GivenC>, Inputs, Outputs>
    : std::type_identity<AreNoInputs<Inputs>> {};
template <class C, class... Parts, class GivenC, class... Input, class Outputs>
struct FaultOfArguments<CraftScenario<C, Parts...>, CraftState<GivenC>, CraftInputs<Input...>, Outputs>
    : std::type_identity<AreNoOutputs<Outputs>> {};
template <class C, class... Parts, class GivenC, class... Input, class... F>
struct FaultOfArguments<CraftScenario<C, Parts...>, CraftState<GivenC>, CraftInputs<Input...>,
                        CraftOutputs<F...>>
    : std::type_identity<
          FaultOfLinear<C, GivenC, CraftScenario<C, Parts...>, CraftInputs<Input...>, CraftOutputs<F...>>> {};

/// The rates of a craft in duals, under loads and inputs.
template <CraftType C, class... Input, class... Loads>
auto dual_rates(const std::shared_ptr<const CraftCoreIn<Dual>>& core, const std::tuple<Loads...>& loads,
                const InputLoad<C, Dual, Input...>& inputs) {
  return std::apply(
      [&](const Loads&... load) {
        return CraftRatesIn<C, Dual, Loads..., InputLoad<C, Dual, Input...>>(core, load..., inputs);
      },
      loads);
}

}  // namespace detail

/// The derivatives of the motion of a scenario about a state, by automatic differentiation, with the values
/// that a run from this state holds at its start. The coordinates of x are
///     theta     R_h^i = R0_h^i exp([theta]x), in the axes of the hub
///     rho, nu   place and velocity of a free hub, R0^T (r - r0) and R0^T (v - v0)
/// the same theta of ball and free joints, and the differences of all other numbers of the state. If the
/// state is not one of rest or of steady turning, A holds at this instant of the motion only. Loads take any
/// scalar: generic functions, or []<class S>(const Now<C, S>&, Forces<C, S>&). Throws BadInput if a
/// derivative is not finite.
template <CraftType C, class... Parts, class... Input, class... F>
  requires(std::is_same_v<
           detail::FaultOfLinear<C, C, CraftScenario<C, Parts...>, CraftInputs<Input...>, CraftOutputs<F...>>,
           Nothing>)
LinearCraft<C, Input...> linearise(const CraftScenario<C, Parts...>& scenario, const CraftState<C>& state,
                                   const CraftInputs<Input...>& = {},
                                   const CraftOutputs<F...>& outputs = {}) {
  using Motion = CraftMotion<C, Dual>;
  constexpr std::size_t inputs = (std::size_t{0} + ... + detail::InputOn<C, Input>::size);
  const auto start = detail::start_of_run("linearise", scenario, state);
  const detail::CraftCore& core = *scenario.craft().core();
  const auto duals = detail::in_duals(core);
  const detail::ErrorsOfState errors(core);
  const auto n = static_cast<Eigen::Index>(errors.size()), m = static_cast<Eigen::Index>(inputs);

  std::array<Dual, inputs + 1> u{};
  auto rates = detail::dual_rates(duals, detail::held_loads(scenario.parts(), start.held),
                                  detail::InputLoad<C, Dual, Input...>{u.data()});
  LinearCraft<C, Input...> system{LinearSystem{}};
  decltype(system.A) of_outputs;
  // Along the error i; along none from n on.
  const auto column = [&](Eigen::Index i) {
    const auto along = decltype(of_outputs)::Identity(n, n + m).col(i).eval();
    typename CraftState<C, Dual>::Numbers y{}, ydot{};
    errors.depart(start.y, along, y);
    rates(state.time().value(), y.data(), ydot.data());
    if constexpr (sizeof...(F) > 0) {
      const Motion motion(detail::trusted, duals, CraftState<C, Dual>(detail::trusted, state.time(), y), ydot,
                          rates.work());
      std::vector<Dual> measured;
      std::apply(
          [&](const auto&... output) { (detail::append_numbers(output.function(motion), measured), ...); },
          outputs.list);
      of_outputs.conservativeResize(static_cast<Eigen::Index>(measured.size()), n + m);
      for (std::size_t k = 0; k < measured.size(); ++k)
        of_outputs(static_cast<Eigen::Index>(k), i) = measured[k].derivatives();
    }
    return errors.rates(start.y, along, y, ydot);
  };
  of_outputs.resize(0, n + m);
  system.A.resize(n, n);
  system.B.resize(n, m);
  for (Eigen::Index i = 0; i < n; ++i) system.A.col(i) = column(i);
  for (Eigen::Index i = 0; i < m; ++i) {
    u[static_cast<std::size_t>(i)] = {0.0, 1.0};
    system.B.col(i) = column(n + i);
    u[static_cast<std::size_t>(i)] = 0.0;
  }
  system.C = of_outputs.leftCols(n);
  system.D = of_outputs.rightCols(m);

  const auto add = [](auto& names, const auto& more) { names.insert(names.end(), more.begin(), more.end()); };
  system.state_names = errors.names();
  (add(system.input_names, detail::InputOn<C, Input>::names()), ...);
  std::apply(
      [&](const auto&... output) {
        (add(system.output_names, detail::names_of_output<detail::OutputValue<C, F>>(output.name)), ...);
      },
      outputs.list);
  detail::require_derivatives(core, system.A, system.state_names, system.state_names);
  detail::require_derivatives(core, system.B, system.state_names, system.input_names);
  detail::require_derivatives(core, system.C, system.output_names, system.state_names);
  detail::require_derivatives(core, system.D, system.output_names, system.input_names);
  return system;
}

template <class Scenario, class State = Nothing, class Inputs = CraftInputs<>, class Outputs = CraftOutputs<>,
          class Fault = typename detail::FaultOfArguments<Scenario, State, Inputs, Outputs>::type>
  requires(!std::is_same_v<Fault, Nothing>)
auto linearise(  // a scenario, a state of its craft, inputs(), outputs(); loads of any scalar: see Fault
    const Scenario&, const State& = {}, const Inputs& = {}, const Outputs& = {}) -> Refused = delete;

}  // namespace vectrix
