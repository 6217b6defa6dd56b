#pragma once

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cstddef>

#include "attitude.hpp"
#include "engines.hpp"

/// A problem through Boost's odeint.
namespace bench {

namespace odeint = boost::numeric::odeint;

template <std::size_t N, class S = double>
using Fehlberg78 = odeint::runge_kutta_fehlberg78<std::array<S, N>, S>;

template <class P> auto odeint_rkf78(const P& problem) {
  return [own = problem](double tolerance) mutable {
    std::size_t evaluations = 0;
    const auto rates = [&](const Numbers<P::size>& y, Numbers<P::size>& ydot, double) {
      ++evaluations;
      own(y.data(), ydot.data());
    };
    Numbers<P::size> y = own.initial;
    const double first_step = 1e-5 * own.end;
    odeint::integrate_adaptive(odeint::make_controlled(tolerance, tolerance, Fehlberg78<P::size>()), rates, y,
                               0.0, own.end, first_step);
    return Result{attitude(y), evaluations};
  };
}

/// The attitude at the end by steps of a fixed length in long double, and how much it changes when the steps
/// are twice as long.
struct Reference {
  Attitude at_end;
  double doubt;
};
template <class P> Reference reference(const P& problem, int steps) {
  using Real = long double;
  using State = std::array<Real, P::size>;
  auto rates = problem.template rates<Real>();
  const auto call = [&](const State& y, State& ydot, Real) { rates(y.data(), ydot.data()); };
  const auto run = [&](int count) {
    State y;
    for (std::size_t i = 0; i < P::size; ++i) y[i] = problem.initial[i];
    const Real h = Real(problem.end) / count;
    Fehlberg78<P::size, Real> method;
    for (int i = 0; i < count; ++i) method.do_step(call, y, h * i, h);
    return attitude(y);
  };
  const Attitude at_end = run(steps);
  return {at_end, angle_between(at_end, run(steps / 2))};
}

}  // namespace bench
