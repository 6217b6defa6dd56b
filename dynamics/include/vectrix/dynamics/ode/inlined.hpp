#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include <vectrix/dynamics/ode/rates_of_segment.hpp>
#include <vectrix/dynamics/ode/runge_kutta.hpp>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/dynamics/ode/stepper.hpp>
#include <vectrix/dynamics/ode/verner_7.hpp>
#include <vectrix/dynamics/ode/verner_9.hpp>
#include <vectrix/frames/errors.hpp>

namespace vectrix::ode {

namespace detail {

/// An integrator with an inlined right-hand side, as a stepper of the loop. The length of its steps is
/// carried from segment to segment.
template <class Table, std::size_t N, SegmentRates<N> F> class InlinedStepper final : public Stepper {
 public:
  InlinedStepper(const Problem& problem, F rhs)
      : problem_(problem),
        method_({std::move(rhs), &problem}, problem.relative_tolerance,
                state_of(problem.absolute_tolerances)) {}

  void enter_segment(double start, double end) override {
    method_.rates().start = start;
    method_.rates().end = end;
  }
  void evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) override {
    method_.rates()(elapsed, state_of(y), std::span<double, N>(ydot.data(), ydot.size()));
    method_.rates().require_none();
  }
  void restart(double elapsed, std::span<const double> y, double stop, double longest) override {
    stop_ = stop;
    longest_ = longest;
    method_.start(elapsed, state_of(y), method_.next_step());
  }
  double step() override {
    const Advance advance = method_.step(stop_, longest_);
    if (advance == Advance::too_short || advance == Advance::not_finite) [[unlikely]] {
      throw_failed(advance);
    }
    method_.rates().trouble.reset();  // that of attempts with longer steps
    return method_.time();
  }
  [[nodiscard]] std::span<const double> state() const override { return method_.state(); }
  void rate(std::span<double> ydot) override {
    const auto found = method_.rate();
    method_.rates().require_none();
    std::copy(found.begin(), found.end(), ydot.begin());
  }
  [[nodiscard]] std::size_t degree() const override { return Table::degree; }
  void terms(std::span<double> terms) override {
    method_.terms(terms);
    method_.rates().require_none();
  }
  [[nodiscard]] std::size_t evaluations() const override { return method_.rates().evaluations; }
  [[nodiscard]] std::size_t error_test_failures() const override { return method_.rejections(); }
  [[nodiscard]] std::string worst_component() const override {
    return component_name(problem_, method_.worst_component());
  }

 private:
  static std::span<const double, N> state_of(std::span<const double> y) {
    return std::span<const double, N>(y.data(), y.size());
  }

  [[noreturn]] void throw_failed(Advance advance) const {
    const double t = method_.rates().time(method_.time());
    if (advance == Advance::not_finite) {
      method_.rates().require_none();
      throw Trouble{flag::rhs_failed, t, "a step from t = " + text(t) + " overflows", nullptr};
    }
    constexpr double near_rounding = 100 * std::numeric_limits<double>::epsilon();
    throw Trouble{
        flag::step_too_short, t,
        "the step fell below " + text(method_.next_step()) + ", and the error of " + worst_component() +
            " is still too large; " +
            (problem_.relative_tolerance < near_rounding
                 ? "the relative tolerance, " + text(problem_.relative_tolerance) + ", is near rounding"
                 : "a stiff problem needs radau_iia_7"),
        nullptr};
  }

  const Problem& problem_;
  RungeKutta<Table, N, RatesOfSegment<N, F>> method_;
  double stop_ = 0.0;
  double longest_ = 0.0;
};

/// Checks the problem, except its right-hand side, and runs it on the stepper made then.
VECTRIX_EXPORT Solution solve_with(const Problem& problem,
                                   const std::function<std::unique_ptr<Stepper>()>& make_stepper);

/// The stepper of one of Verner's methods; null for another method.
template <std::size_t N, class F> std::unique_ptr<Stepper> make_inlined(const Problem& problem, F rhs) {
  if (problem.method == Method::verner_9)
    return std::make_unique<InlinedStepper<Verner9, N, F>>(problem, std::move(rhs));
  if (problem.method == Method::verner_7)
    return std::make_unique<InlinedStepper<Verner7, N, F>>(problem, std::move(rhs));
  return nullptr;
}

}  // namespace detail

/// solve(problem) for N components with the right-hand side rhs(segment_start, t, y, ydot) inlined, by
/// verner_9 or verner_7: several times as fast for a small state. y and ydot are spans of N numbers.
/// `problem.rhs` stays empty. Throws as solve(problem), and BadInput for another method or another number of
/// components.
template <std::size_t N, SegmentRates<N> F> Solution solve(const Problem& problem, F rhs) {
  return detail::solve_with(problem, [&] {
    const auto require = [&](bool condition, const std::string& message) {
      if (!condition) throw BadInput(problem.caller + ": " + message);
    };
    require(!problem.rhs, "the problem has a right-hand side, and another one is given");
    require(problem.initial_state.size() == N, "the right-hand side has " + detail::text(N) +
                                                   " components, the initial state has " +
                                                   detail::text(problem.initial_state.size()));
    auto stepper = detail::make_inlined<N>(problem, std::move(rhs));
    require(stepper != nullptr, "a right-hand side is inlined by verner_9 and verner_7 only");
    return stepper;
  });
}

}  // namespace vectrix::ode
