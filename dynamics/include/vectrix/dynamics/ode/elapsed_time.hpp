#pragma once

namespace vectrix::ode {

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
};

}  // namespace vectrix::ode
