#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/orbit/kepler_equation.hpp>

#include "temporary_file.hpp"

namespace vectrix::kepler_equation_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Of the root itself: three roundings after the solution, and that of the given anomaly.
constexpr double root_tolerance = 4 * epsilon;
// Of functions of sines and roots, each with a rounding or two.
constexpr double conversion_tolerance = 16 * epsilon;

using Real = long double;

MeanAnomaly mean(double M) {
  return MeanAnomaly(M * si::radian);
}
EccentricAnomaly eccentric(double E) {
  return EccentricAnomaly(E * si::radian);
}
TrueAnomaly true_of(double nu) {
  return TrueAnomaly(nu * si::radian);
}

// E - sin E, or sinh F - F, without cancellation: E^3/3! -+ E^5/5! + ...
Real cubic_part(Real E, Real sign) {
  if (std::abs(E) > 2) return sign > 0 ? E - std::sin(E) : std::sinh(E) - E;
  Real sum = 1;
  for (int n = 41; n > 3; n -= 2) sum = 1 - sign * E * E * sum / (n * (n - 1));
  return E * E * E * sum / 6;
}
// M of E, and dM/dE = r/|a|
Real mean_of(Real E, Real e) {
  return std::abs(1 - e) * E + e * cubic_part(E, e < 1 ? 1 : -1);
}
Real slope_of(Real E, Real e) {
  const Real half = e < 1 ? std::sin(E / 2) : std::sinh(E / 2);
  return std::abs(1 - e) + 2 * e * half * half;
}

// The given M is rounded: the root belongs to the rounded one.
void expect_root(double E, double e) {
  const auto M = static_cast<double>(mean_of(E, e));
  const Real root = E + (M - mean_of(E, e)) / slope_of(E, e);
  EXPECT_LE(std::abs(static_cast<double>(eccentric_anomaly(mean(M), e).angle.value() - root)),
            root_tolerance * std::abs(E))
      << "E = " << E << ", e = " << e;
}

TEST(KeplerEquation, RootsOfAllEccentricities) {
  std::mt19937_64 random(20270111);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 3000; ++i) {
    const double small = std::pow(10.0, -9.0 * unit(random)), near = std::pow(10.0, -15.6 * unit(random));
    const double E = (2.0 * unit(random) - 1.0) * pi * (i % 2 ? 1.0 : small);
    expect_root(E, unit(random));
    expect_root(E, 1.0 - near);
    expect_root(3.0 * E, 1.0 + near);
    expect_root(3.0 * E, 1.0 + std::pow(10.0, 4.0 * unit(random)));
  }
}

TEST(KeplerEquation, CornersOfTheEllipse) {
  for (const double e : {0.0, 1e-300, 0.3, 0.999, 1.0 - epsilon / 2}) {
    EXPECT_EQ(eccentric_anomaly(mean(0.0), e).angle.value(), 0.0);
    EXPECT_NEAR(eccentric_anomaly(mean(pi), e).angle.value(), pi, 2 * epsilon * pi) << e;
    EXPECT_NEAR(eccentric_anomaly(mean(-7 * pi), e).angle.value(), -7 * pi, 16 * epsilon * pi) << e;
    EXPECT_NEAR(true_anomaly(eccentric(5 * pi), e).angle.value(), 5 * pi, 16 * epsilon * pi) << e;
  }
  EXPECT_EQ(eccentric_anomaly(mean(1.25), 0.0).angle.value(), 1.25);
  EXPECT_EQ(true_anomaly(eccentric(1e-5), 0.0).angle.value(), 1e-5);
  // A least mean anomaly: M = (1 - e) E
  EXPECT_NEAR(eccentric_anomaly(mean(1e-300), 0.5).angle.value(), 2e-300, 1e-315);
}

// The largest hyperbolic anomalies: e sinh F alone counts.
TEST(KeplerEquation, FarOutOnAHyperbola) {
  for (const double M : {1e10, 1e100, 1e300}) {
    const double F = eccentric_anomaly(mean(M), 2.0).angle.value();
    EXPECT_NEAR(F, std::asinh((M + F) / 2.0), root_tolerance * F);
    EXPECT_NEAR(eccentric_anomaly(mean(-M), 2.0).angle.value(), -F, epsilon * F);
  }
}

// r cos nu = a (cos E - e), r sin nu = a (1 - e^2)^1/2 sin E
TEST(KeplerEquation, TrueAnomalyByItsDefinition) {
  std::mt19937_64 random(20270112);
  std::uniform_real_distribution<double> angle(-pi, pi), unit(0.0, 0.9);
  for (int i = 0; i < 1000; ++i) {
    const double E = angle(random), e = unit(random);
    const double nu = true_anomaly(eccentric(E), e).angle.value();
    EXPECT_NEAR(nu, std::atan2(std::sqrt(1 - e * e) * std::sin(E), std::cos(E) - e),
                conversion_tolerance * pi * 4);
    const double over = 1.2 + 3 * unit(random);
    const double hyperbolic = true_anomaly(eccentric(E), over).angle.value();
    EXPECT_NEAR(hyperbolic, std::atan2(std::sqrt(over * over - 1) * std::sinh(E), over - std::cosh(E)),
                conversion_tolerance * pi * 4);
  }
}

TEST(KeplerEquation, EveryAnomalyAndBack) {
  std::mt19937_64 random(20270113);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double E = 8.0 * unit(random), e = std::abs(unit(random));
    EXPECT_NEAR(eccentric_anomaly(true_anomaly(eccentric(E), e), e).angle.value(), E,
                conversion_tolerance * 8 / (1 - e));
    EXPECT_NEAR(eccentric_anomaly(mean_anomaly(eccentric(E), e), e).angle.value(), E,
                conversion_tolerance * 8 / (1 - e));
    const double F = 3.0 * unit(random), over = 1.01 + e;
    EXPECT_NEAR(eccentric_anomaly(true_anomaly(eccentric(F), over), over).angle.value(), F,
                conversion_tolerance * 8 * std::exp(3.0));
    EXPECT_NEAR(eccentric_anomaly(mean_anomaly(eccentric(F), over), over).angle.value(), F,
                conversion_tolerance * 3);
  }
}

constexpr auto mu = Quantity<si::gravitational_parameter>::from_value(3.986004415e14);
constexpr auto q = 7e6 * si::metre;

// D + D^3/3 = (mu/(2 q^3))^1/2 t, D = tan nu/2
TEST(KeplerEquation, ParabolaByBarkersEquation) {
  for (const double nu : {-3.0, -1.0, -1e-6, 0.0, 0.4, 2.0, 3.1}) {
    const double D = std::tan(nu / 2);
    const double t = (D + D * D * D / 3) * std::sqrt(2.0 * std::pow(q.value(), 3) / mu.value());
    EXPECT_NEAR(true_anomaly(t * si::second, mu, q, 1.0).angle.value(), nu,
                conversion_tolerance * std::abs(nu));
    EXPECT_NEAR(time_since_periapsis(true_of(nu), mu, q, 1.0).value(), t,
                conversion_tolerance * std::abs(t) * (1 + D * D));
  }
}

// From e < 1 over the parabola to e > 1 the true anomaly at one time is smooth.
TEST(KeplerEquation, NoJumpAtTheParabola) {
  const auto t = 5000.0 * si::second;
  const double parabola = true_anomaly(t, mu, q, 1.0).angle.value();
  for (const double step : {1e-16, 1e-12, 1e-8, 1e-6}) {
    const double before = true_anomaly(t, mu, q, 1.0 - step).angle.value();
    const double after = true_anomaly(t, mu, q, 1.0 + step).angle.value();
    EXPECT_NEAR(before, parabola, 2 * epsilon + step);
    EXPECT_NEAR(after, parabola, 2 * epsilon + step);
    EXPECT_NEAR(before + after, 2 * parabola, 4 * epsilon + step * step);
  }
}

// The time is M (a^3/mu)^1/2, beyond a revolution too.
TEST(KeplerEquation, TimeFromPeriapsis) {
  for (const double e : {0.0, 0.2, 0.9, 1.5, 30.0}) {
    const double seconds = std::sqrt(std::pow(q.value() / std::abs(1 - e), 3) / mu.value());
    for (const double M : {-1.0, 0.0, 0.5, 2.0, 9.0, -20.0}) {
      const double nu = true_anomaly(eccentric_anomaly(mean(M), e), e).angle.value();
      EXPECT_NEAR(true_anomaly(M * seconds * si::second, mu, q, e).angle.value(), nu,
                  conversion_tolerance * 4 * pi / std::abs(1 - e));
      EXPECT_NEAR(time_since_periapsis(true_of(nu), mu, q, e).value(), M * seconds,
                  conversion_tolerance * seconds * 200 / std::abs(1 - e));
    }
  }
}

TEST(KeplerEquation, RefusesWhatHasNoAnomaly) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint([] { return eccentric_anomaly(mean(1.0), 1.0); }),
            "eccentric_anomaly: the eccentricity is 1; a parabola has only a true anomaly");
  EXPECT_EQ(complaint([] { return eccentric_anomaly(mean(1.0), -0.1); }),
            "eccentric_anomaly: the eccentricity is -0.1; it must be finite and not negative");
  EXPECT_EQ(complaint([] { return mean_anomaly(eccentric(1.0), nan); }),
            "mean_anomaly: the eccentricity is nan; it must be finite and not negative");
  EXPECT_EQ(complaint([] { return true_anomaly(eccentric(infinity), 0.1); }),
            "true_anomaly: the eccentric anomaly is inf; it must be finite");
  EXPECT_EQ(complaint([] { return eccentric_anomaly(mean(nan), 0.1); }),
            "eccentric_anomaly: the mean anomaly is nan; it must be finite");
  EXPECT_EQ(complaint([] { return eccentric_anomaly(true_of(2.5), 2.0); }),
            "eccentric_anomaly: the true anomaly is 2.5 rad, not inside the asymptotes of the orbit");
  EXPECT_EQ(complaint([] { return time_since_periapsis(true_of(pi + 1.0), mu, q, 1.0); }),
            "time_since_periapsis: the true anomaly is 4.141592653589793 rad, not inside the asymptotes of "
            "the orbit");
  EXPECT_EQ(complaint([] { return true_anomaly(1.0 * si::second, -1.0 * mu, q, 0.1); }),
            "true_anomaly: mu is -398600441500000 m^3/s^2; it must be finite and positive");
  EXPECT_EQ(complaint([] { return true_anomaly(1.0 * si::second, mu, 0.0 * q, 0.1); }),
            "true_anomaly: the periapsis distance is 0 m; it must be finite and positive");
  EXPECT_EQ(complaint([nan] { return true_anomaly(nan * si::second, mu, q, 0.1); }),
            "true_anomaly: the time is nan; it must be finite");
}

}  // namespace
}  // namespace vectrix::kepler_equation_test
