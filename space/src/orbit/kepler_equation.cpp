#include <cmath>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/orbit/kepler_equation.hpp>

#include "universal_kepler.hpp"

namespace vectrix {
namespace {

using detail::UniversalOrbit, detail::text, detail::universal_anomaly, detail::universal_functions;

constexpr double full_turn = 2.0 * std::numbers::pi;

// Kepler's equation from periapsis in the units mu = q = 1.
UniversalOrbit from_periapsis(double e) {
  return {1.0, 1.0, 0.0, 1.0 - e, e, 1.0 + e};
}

void require(bool good, const char* action, const char* what, double value, const char* rule) {
  if (!good) throw BadInput(std::string{action} + ": " + what + " is " + text(value) + rule);
}
void require_finite(double x, const char* action, const char* what) {
  require(std::isfinite(x), action, what, x, "; it must be finite");
}
void require_eccentricity(double e, const char* action) {
  require(e >= 0.0 && std::isfinite(e), action, "the eccentricity", e,
          "; it must be finite and not negative");
}
void require_no_parabola(double e, const char* action) {
  require_eccentricity(e, action);
  require(e != 1.0, action, "the eccentricity", e, "; a parabola has only a true anomaly");
}
void require_inside_asymptotes(double nu, double e, const char* action) {
  require(e < 1.0 || (std::abs(nu) < std::numbers::pi && 1.0 + e * std::cos(nu) > 0.0), action,
          "the true anomaly", nu, " rad, not inside the asymptotes of the orbit");
}

// x = within + whole turns, |within| <= pi, where a conic is closed.
struct Turns {
  double within, whole;
};
Turns turns(double x, double e) {
  if (e >= 1.0) return {x, 0.0};
  const double within = std::remainder(x, full_turn);
  return {within, x - within};
}

// tan nu/2 = sqrt(1 + e) G_1(s/2) / G_0(s/2)
double true_from_universal(double s, double e) {
  const auto G = universal_functions(1.0 - e, 0.5 * s);
  return 2.0 * std::atan2(std::sqrt(1.0 + e) * G.G1, G.G0);
}
double universal_from_true(double nu, double e) {
  const double sine = std::sin(0.5 * nu), cosine = std::sqrt(1.0 + e) * std::cos(0.5 * nu);
  const double root = std::sqrt(std::abs(1.0 - e));
  if (e == 1.0 || sine == 0.0) return 2.0 * sine / cosine;
  return 2.0 * (e < 1.0 ? std::atan2(root * sine, cosine) : std::atanh(root * sine / cosine)) / root;
}

// (mu/q^3)^1/2, 1/s
double periapsis_rate(double mu, double q, const char* action) {
  require(mu > 0.0 && std::isfinite(mu), action, "mu", mu, " m^3/s^2; it must be finite and positive");
  require(q > 0.0 && std::isfinite(q), action, "the periapsis distance", q,
          " m; it must be finite and positive");
  return std::sqrt(mu / q) / q;
}

}  // namespace

EccentricAnomaly eccentric_anomaly(const MeanAnomaly& M, double e) {
  require_no_parabola(e, "eccentric_anomaly");
  require_finite(M.angle.value(), "eccentric_anomaly", "the mean anomaly");
  const auto [within, whole] = turns(M.angle.value(), e);
  const double root = std::sqrt(std::abs(1.0 - e));
  const double s = universal_anomaly(from_periapsis(e), within / (root * root * root));
  return EccentricAnomaly((whole + root * s) * si::radian);
}

MeanAnomaly mean_anomaly(const EccentricAnomaly& E, double e) {
  require_no_parabola(e, "mean_anomaly");
  require_finite(E.angle.value(), "mean_anomaly", "the eccentric anomaly");
  const auto [within, whole] = turns(E.angle.value(), e);
  const double sign = e < 1.0 ? 1.0 : -1.0;
  // (1 - e) E + e (E - sin E), and likewise of a hyperbola
  const double M = std::abs(1.0 - e) * within + e * universal_functions(sign, within).G3;
  require_finite(M, "mean_anomaly", "the mean anomaly");
  return MeanAnomaly((whole + M) * si::radian);
}

TrueAnomaly true_anomaly(const EccentricAnomaly& E, double e) {
  require_no_parabola(e, "true_anomaly");
  require_finite(E.angle.value(), "true_anomaly", "the eccentric anomaly");
  const auto [within, whole] = turns(E.angle.value(), e);
  const double root = std::sqrt(std::abs(1.0 - e)), half = 0.5 * within;
  const double nu = e < 1.0 ? std::atan2(std::sqrt(1.0 + e) * std::sin(half), root * std::cos(half))
                            : std::atan2(std::sqrt(1.0 + e) * std::tanh(half), root);
  return TrueAnomaly((whole + 2.0 * nu) * si::radian);
}

EccentricAnomaly eccentric_anomaly(const TrueAnomaly& nu, double e) {
  require_no_parabola(e, "eccentric_anomaly");
  require_finite(nu.angle.value(), "eccentric_anomaly", "the true anomaly");
  require_inside_asymptotes(nu.angle.value(), e, "eccentric_anomaly");
  const auto [within, whole] = turns(nu.angle.value(), e);
  return EccentricAnomaly((whole + std::sqrt(std::abs(1.0 - e)) * universal_from_true(within, e)) *
                          si::radian);
}

TrueAnomaly true_anomaly(const Quantity<si::time>& since_periapsis,
                         const Quantity<si::gravitational_parameter>& mu,
                         const Quantity<si::length>& periapsis_distance, double e) {
  require_eccentricity(e, "true_anomaly");
  require_finite(since_periapsis.value(), "true_anomaly", "the time");
  const double rate = periapsis_rate(mu.value(), periapsis_distance.value(), "true_anomaly");
  double t = rate * since_periapsis.value(), whole = 0.0;
  if (e < 1.0) {
    const double period = full_turn / ((1.0 - e) * std::sqrt(1.0 - e));
    const double within = std::remainder(t, period);
    whole = full_turn * std::round((t - within) / period);
    t = within;
  }
  return TrueAnomaly((whole + true_from_universal(universal_anomaly(from_periapsis(e), t), e)) * si::radian);
}

Quantity<si::time> time_since_periapsis(const TrueAnomaly& nu,
                                        const Quantity<si::gravitational_parameter>& mu,
                                        const Quantity<si::length>& periapsis_distance, double e) {
  require_eccentricity(e, "time_since_periapsis");
  require_finite(nu.angle.value(), "time_since_periapsis", "the true anomaly");
  require_inside_asymptotes(nu.angle.value(), e, "time_since_periapsis");
  const double rate = periapsis_rate(mu.value(), periapsis_distance.value(), "time_since_periapsis");
  const auto [within, whole] = turns(nu.angle.value(), e);
  const double s = universal_from_true(within, e);
  double t = s + e * universal_functions(1.0 - e, s).G3;
  if (whole != 0.0) t += whole / ((1.0 - e) * std::sqrt(1.0 - e));
  require_finite(t, "time_since_periapsis", "the time");
  return t / rate * si::second;
}

}  // namespace vectrix
