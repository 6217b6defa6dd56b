#include "universal_kepler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <vectrix/frames/scalar/stumpff.hpp>

namespace vectrix::detail {
namespace {

// Above this |x| the closed forms of Stumpff's functions lose at most three bits.
constexpr double series_limit = 9.0;

// A time after periapsis from its anomalies: a first value of F in e sinh F - F = N, N >= 0. Both bounds lie
// above the root, because sinh F - F > F^3/6.
double hyperbolic_guess(double N, double e) {
  const double above = std::min(std::cbrt(6.0 * N), std::asinh(N / (e - 1.0)));
  return std::asinh((N + above) / e);
}

double eccentricity(const UniversalOrbit& o) {
  return std::sqrt(std::max(0.0, 1.0 - o.beta * o.h2 / (o.mu * o.mu)));
}

// F and N = e sinh F - F of a hyperbola, from e sinh F = eta (-beta)^1/2 / mu.
struct HyperbolicAnomalies {
  double e, F, N, root, rate;  // root: (-beta)^1/2; rate: dN/dt

  explicit HyperbolicAnomalies(const UniversalOrbit& o)
      : e(eccentricity(o)), F(0.0), N(0.0), root(std::sqrt(-o.beta)), rate(root * root * root / o.mu) {
    const double sine = o.eta * root / o.mu;
    F = std::asinh(sine / e);
    N = sine - F;
  }
};

double first_value(const UniversalOrbit& o, double dt) {
  if (o.beta >= 0.0) return o.beta * dt / o.mu;
  const HyperbolicAnomalies start(o);
  const double N = start.N + start.rate * dt;
  return (std::copysign(hyperbolic_guess(std::abs(N), start.e), N) - start.F) / start.root;
}

}  // namespace

UniversalFunctions universal_functions(double beta, double s) {
  const double x = beta * s * s;
  double c0, c1, c2, c3, c4, c5;
  if (std::abs(x) < series_limit) {
    c4 = stumpff_series<4>(x) / 24.0;
    c5 = stumpff_series<5>(x) / 120.0;
    c3 = 1.0 / 6.0 - x * c5;
    c2 = 0.5 - x * c4;
    c1 = 1.0 - x * c3;
    c0 = 1.0 - x * c2;
  } else {
    const double y = std::sqrt(std::abs(x));
    const double half = x > 0.0 ? std::sin(0.5 * y) : std::sinh(0.5 * y);
    c0 = x > 0.0 ? std::cos(y) : std::cosh(y);
    c1 = (x > 0.0 ? std::sin(y) : std::sinh(y)) / y;
    c2 = 2.0 * (half / y) * (half / y);
    c3 = (1.0 - c1) / x;
    c4 = (0.5 - c2) / x;
    c5 = (1.0 / 6.0 - c3) / x;
  }
  const double s2 = s * s;
  return {c0, s * c1, s2 * c2, s2 * s * c3, s2 * s2 * c4, s2 * s2 * s * c5};
}

// dt grows with s. Laguerre's method for a polynomial of degree 5 (Conway, An improved algorithm due to
// Laguerre for the solution of Kepler's equation, 1986), inside a bracket that every value shrinks; a step
// out of the bracket is replaced by a bisection.
double universal_anomaly(const UniversalOrbit& o, double dt) {
  if (dt == 0.0) return 0.0;
  // |dt|/r_max <= |s| <= |dt|/r_min, r_min = h^2/(mu (1 + e)). Where r_min is small: an ellipse's E differs
  // from M by at most e at both ends; else dt > mu s^3/24, which is so if periapsis is in the middle.
  const double e = eccentricity(o), size = std::abs(dt);
  constexpr double slack = 1e-6;  // for the rounding of the bounds
  double low = 0.0, high = (1.0 + slack) * std::cbrt(24.0 * size / o.mu);
  if (o.beta > 0.0) {
    low = (1.0 - slack) * size * o.beta / (o.mu * (1.0 + e));
    high = (1.0 + slack) * (size * o.beta / o.mu + 2.0 * e / std::sqrt(o.beta));
  }
  if (o.h2 > 0.0) high = std::min(high, (1.0 + slack) * size * o.mu * (1.0 + e) / o.h2);
  if (dt < 0.0) {
    std::swap(low, high);
    low = -low;
    high = -high;
  }
  double s = std::clamp(first_value(o, dt), low, high);
  constexpr int at_most = 200;  // two to five are usual
  for (int i = 0; i < at_most; ++i) {
    const UniversalFunctions G = universal_functions(o.beta, s);
    const double f = o.r * s + o.eta * G.G2 + o.zeta * G.G3 - dt;
    // Where the terms cancel no root is better than this.
    const double rounding = std::numeric_limits<double>::epsilon() *
                            (std::abs(o.r * s) + std::abs(o.eta * G.G2) + std::abs(o.zeta * G.G3));
    (f < 0.0 ? low : high) = s;  // also for +inf; NaN comes with it
    const double slope = o.r + o.eta * G.G1 + o.zeta * G.G2;
    const double curvature = o.eta * G.G0 + o.zeta * G.G1;
    const double root = std::sqrt(std::abs(16.0 * slope * slope - 20.0 * f * curvature));
    const double step = -5.0 * f / (slope + root);
    const double next = s + step;
    // From 1e-9 of s the method's next error is far below rounding.
    if (std::abs(step) <= 1e-9 * std::abs(s) || std::abs(f) <= rounding) return next;
    s = next > low && next < high ? next : low + 0.5 * (high - low);
  }
  return s;
}

double time_since_periapsis(const UniversalOrbit& o) {
  const HyperbolicAnomalies now(o);
  return now.N / now.rate;
}

}  // namespace vectrix::detail
