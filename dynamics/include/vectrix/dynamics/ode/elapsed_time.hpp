#pragma once

#include <limits>

namespace vectrix::ode {

/// A step towards an end: `last` if it ends there, `too_short` if it would not change the time.
struct StepLength {
  double length;
  bool last;
  bool too_short;
};

/// A sum of steps with the rounding error of its own: after a million steps it is still exact to rounding.
struct ElapsedTime {
  double sum = 0.0;
  double rest = 0.0;  ///< rounding error of the sum

  /// sum + rest += step. The rest takes the exact rounding error of the sum, whichever term is larger.
  void add(double step) {
    const double next = sum + step;
    const double part = next - sum;
    rest += (sum - (next - part)) + (step - part);
    sum = next;
  }

  /// What is left until an end, counted from the same start.
  [[nodiscard]] double remaining(double end) const { return end - sum - rest; }

  /// The next step, of the wanted length or to the end, if that is within rounding of it.
  [[nodiscard]] StepLength next(double wanted, double end) const {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double left = remaining(end);
    const bool last = wanted >= left - 16.0 * epsilon * (sum + left);
    return {last ? left : wanted, last, !last && !(wanted > 4.0 * epsilon * sum)};
  }
};

}  // namespace vectrix::ode
