#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/dynamics/ode/stepper.hpp>
#include <vectrix/frames/errors.hpp>

namespace vectrix::ode {

/// A right-hand side that the integrator inlines: as RightHandSide, with spans of N numbers.
template <class F, std::size_t N>
concept SegmentRates = std::invocable<F&, double, double, std::span<const double, N>, std::span<double, N>>;

namespace detail {

using vectrix::detail::text;

/// The right-hand side at a time since the start of the segment. It never sees a time outside the segment or
/// a state that is not finite. What it throws becomes a Trouble, which is thrown. A rate that is not finite
/// is kept as one: a shorter step may avoid it. A state that is not finite gets such a rate.
template <std::size_t N, SegmentRates<N> F> struct RatesOfSegment {
  F rhs;
  const Problem* problem;
  double start = 0.0;
  double end = 0.0;
  std::size_t evaluations = 0;
  std::optional<Trouble> trouble = std::nullopt;  ///< the last that was kept

  [[nodiscard]] double time(double elapsed) const { return std::clamp(start + elapsed, start, end); }

  void operator()(double elapsed, std::span<const double, N> y, std::span<double, N> ydot) {
    const double t = time(elapsed);
    if (!finite(y)) [[unlikely]] {
      if (!trouble) keep(y, " of a stage is ", t);
      std::fill(ydot.begin(), ydot.end(), std::numeric_limits<double>::quiet_NaN());
      return;
    }
    ++evaluations;
    try {
      rhs(start, t, y, ydot);
    } catch (...) {
      throw Trouble{flag::rhs_failed, t, "the right-hand side threw", std::current_exception()};
    }
    if (!finite(ydot)) [[unlikely]] {
      keep(ydot, " of the right-hand side is ", t);
      trouble->text += why_not_finite(*problem, start, t, y);
    }
  }

  /// Throws what was kept.
  void require_none() const {
    if (trouble) [[unlikely]] {
      throw Trouble(*trouble);
    }
  }

 private:
  static bool finite(std::span<const double, N> numbers) {
    constexpr std::size_t together = 4;
    std::array<double, together> wrong{};
    std::size_t i = 0;
    for (; i + together <= numbers.size(); i += together)
      for (std::size_t lane = 0; lane < together; ++lane) wrong[lane] += 0.0 * numbers[i + lane];
    for (; i < numbers.size(); ++i) wrong[0] += 0.0 * numbers[i];
    return (wrong[0] + wrong[1]) + (wrong[2] + wrong[3]) == 0.0;
  }
  void keep(std::span<const double> numbers, const char* what, double t) {
    std::size_t i = 0;
    while (std::isfinite(numbers[i])) ++i;
    trouble = Trouble{flag::rhs_failed, t,
                      component_name(*problem, i) + what + text(numbers[i]) + " at t = " + text(t), nullptr};
  }
};

using RatesByFunction = RatesOfSegment<std::dynamic_extent, std::reference_wrapper<const RightHandSide>>;

}  // namespace detail
}  // namespace vectrix::ode
