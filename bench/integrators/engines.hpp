#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vectrix/dynamics.hpp>

#include "attitude.hpp"
#include "problems.hpp"

/// A problem through the integrators of the library.
namespace bench {

struct Result {
  Attitude at_end;
  std::size_t evaluations;
};
struct Engine {
  std::string name;
  std::function<Result(double tolerance)> run;
};

/// The tolerances of one method, relative and absolute.
template <std::size_t N> Numbers<N> all(double tolerance) {
  Numbers<N> numbers;
  numbers.fill(tolerance);
  return numbers;
}

template <class P> std::string inlined_name(const char* table) {
  return std::string("`RungeKutta<") + table + ", " + std::to_string(P::size) + ">`";
}

/// With the right-hand side inlined, and no loop but its own.
template <class Table, class P> auto stepped(const P& problem) {
  return [own = problem](double tolerance) mutable {
    std::size_t evaluations = 0;
    const auto rates = [&](double, std::span<const double, P::size> y, std::span<double, P::size> ydot) {
      ++evaluations;
      own(y.data(), ydot.data());
    };
    ode::RungeKutta<Table, P::size, decltype(rates)> method(rates, tolerance, all<P::size>(tolerance));
    method.start(0.0, own.initial);
    ode::Advance advance = ode::Advance::stepped;
    while (advance == ode::Advance::stepped) advance = method.step(own.end);
    if (advance != ode::Advance::reached) throw std::runtime_error("RungeKutta does not reach the end");
    return Result{attitude(method.state()), evaluations};
  };
}

template <class P> ode::Problem ode_problem(const P& problem, ode::Method method, double tolerance) {
  ode::Problem run;
  run.initial_state.assign(problem.initial.begin(), problem.initial.end());
  run.start = 0.0;
  run.end = problem.end;
  run.relative_tolerance = tolerance;
  run.absolute_tolerances.assign(P::size, tolerance);
  run.method = method;
  run.dense_output = false;
  return run;
}
inline Result result_of(const ode::Solution& solution) {
  return {attitude(solution.node(solution.node_count() - 1).y), solution.statistics().rhs_evaluations};
}

template <class P> auto solved(const P& problem, ode::Method method, bool dense_output = false) {
  return [=](double tolerance) {
    ode::Problem run = ode_problem(problem, method, tolerance);
    run.dense_output = dense_output;
    run.rhs = [rates = problem](double, double, std::span<const double> y, std::span<double> ydot) mutable {
      rates(y.data(), ydot.data());
    };
    return result_of(ode::solve(run));
  };
}

template <class P> auto solved_inlined(const P& problem) {
  return [=](double tolerance) {
    const auto rates = [own = problem](double, double, std::span<const double, P::size> y,
                                       std::span<double, P::size> ydot) mutable {
      own(y.data(), ydot.data());
    };
    return result_of(ode::solve<P::size>(ode_problem(problem, ode::Method::verner_9, tolerance), rates));
  };
}

/// The typed craft, whose numbers are in SI units.
template <class P> auto start_of(const P& problem) {
  const auto craft = problem.craft();
  using State = CraftState<decltype(problem.craft())>;
  typename State::Numbers y = problem.initial;
  for (std::size_t i = 4; i < 7; ++i) y[i] *= P::rate_unit;
  if constexpr (P::size > 7) {
    for (std::size_t i = 7; i < 10; ++i) y[i] *= P::length_unit;
    for (std::size_t i = 10; i < 13; ++i) y[i] *= P::length_unit * P::rate_unit;
  }
  return State(detail::trusted, 0.0 * si::second, y);
}
template <class P> CraftPropagation propagation(const P& problem, ode::Method method, double tolerance) {
  const double rate = tolerance * P::rate_unit, length = tolerance * P::length_unit;
  return {
      .end = problem.end * P::seconds * si::second,
      .relative_tolerance = tolerance,
      .absolute_tolerances = {tolerance * si::radian, rate * (si::radian / si::second), length * si::metre,
                              length * P::rate_unit * (si::metre / si::second), tolerance},
      .method = method,
      .dense_output = false};
}
template <class P> auto propagated(const P& problem, ode::Method method) {
  const auto flight =
      std::apply([&](const auto&... load) { return scenario(problem.craft(), load...); }, problem.loads());
  return [=](double tolerance) {
    return result_of(
        propagate(flight, start_of(problem), propagation(problem, method, tolerance)).solution());
  };
}

}  // namespace bench
