#include <cmath>
#include <limits>
#include <numbers>

#include <vectrix/space/orbit/two_body.hpp>

#include "universal_kepler.hpp"

namespace vectrix::detail {
namespace {

using Gradient = Eigen::Matrix<double, 1, 6>;  // by (r, v) at the start

// The end of the orbit, r_end = f r + g v, v_end = fdot r + gdot v.
struct LagrangeCoefficients {
  double f, g, fdot, gdot, r;

  LagrangeCoefficients(const UniversalOrbit& o, const UniversalFunctions& G)
      : f(1.0 - o.mu * G.G2 / o.r),
        g(o.r * G.G1 + o.eta * G.G2),
        fdot(0.0),
        gdot(0.0),
        r(o.r + o.eta * G.G1 + o.zeta * G.G2) {
    fdot = -o.mu * G.G1 / (r * o.r);
    gdot = 1.0 - o.mu * G.G2 / r;
  }
};

// The chain rule from (r, v) over |r|, eta and beta, s by the implicit function theorem, to f, g, fdot, gdot.
// drift is d(dt)/d(beta) of whole periods left out.
StateTransition transition_of(const OrbitNumbers& start, const UniversalOrbit& o, double s,
                              const UniversalFunctions& G, const LagrangeCoefficients& end, double drift) {
  Gradient radius, eta, beta;
  radius << start.r.transpose() / o.r, 0.0, 0.0, 0.0;
  eta << start.v.transpose(), start.r.transpose();
  beta << -2.0 * o.mu / (o.r * o.r * o.r) * start.r.transpose(), -2.0 * start.v.transpose();

  const double G0_beta = -0.5 * s * G.G1, G1_beta = 0.5 * (G.G3 - s * G.G2),
               G2_beta = 0.5 * (2.0 * G.G4 - s * G.G3), G3_beta = 0.5 * (3.0 * G.G5 - s * G.G4);
  const double dt_beta = o.r * G1_beta + o.eta * G2_beta + o.mu * G3_beta;
  const Gradient root = -(G.G1 * radius + G.G2 * eta + (dt_beta + drift) * beta) / end.r;
  const Gradient G0 = -o.beta * G.G1 * root + G0_beta * beta;
  const Gradient G1 = G.G0 * root + G1_beta * beta;
  const Gradient G2 = G.G1 * root + G2_beta * beta;
  const Gradient end_radius = G.G0 * radius + G.G1 * eta + o.r * G0 + o.eta * G1 + o.mu * G2;

  const Gradient f = o.mu / o.r * (G.G2 / o.r * radius - G2);
  const Gradient g = G.G1 * radius + o.r * G1 + G.G2 * eta + o.eta * G2;
  const Gradient fdot = -o.mu / (end.r * o.r) * G1 - end.fdot * (end_radius / end.r + radius / o.r);
  const Gradient gdot = o.mu / end.r * (G.G2 / end.r * end_radius - G2);

  const auto identity = Eigen::Matrix3d::Identity();
  StateTransition by_start;
  by_start << end.f * identity, end.g * identity, end.fdot * identity, end.gdot * identity;
  by_start.topRows<3>() += start.r * f + start.v * g;
  by_start.bottomRows<3>() += start.r * fdot + start.v * gdot;
  return by_start;
}

UniversalOrbit universal_orbit(double mu, double beta, const OrbitNumbers& start) {
  const double r = start.r.norm();
  return {mu, r, start.r.dot(start.v), beta, mu - beta * r, start.r.cross(start.v).squaredNorm()};
}

double period_of(const UniversalOrbit& orbit) {
  return 2.0 * std::numbers::pi * orbit.mu / (orbit.beta * std::sqrt(orbit.beta));
}

OrbitNumbers moved(const OrbitNumbers& start, const UniversalOrbit& orbit, double dt,
                   StateTransition* transition) {
  double within = dt, drift = 0.0;
  if (orbit.beta > 0.0) {
    within = std::remainder(dt, period_of(orbit));
    drift = -1.5 * (dt - within) / orbit.beta;
  }
  const double s = universal_anomaly(orbit, within);
  const UniversalFunctions G = universal_functions(orbit.beta, s);
  const LagrangeCoefficients end(orbit, G);
  if (transition) *transition = transition_of(start, orbit, s, G, end, drift);
  return {end.f * start.r + end.g * start.v, end.fdot * start.r + end.gdot * start.v};
}

// To or past the periapsis of a hyperbola, in the axes P to periapsis and Q along the velocity there:
//     r = (q - mu G_2) P + h G_1 Q,  v = (-mu G_1 P + (1 - beta G_2) h Q)/|r|,  |r| = q + mu e G_2
// Without a difference that cancels, where f and g would be as large as r^2.
OrbitNumbers moved_by_periapsis(const OrbitNumbers& start, const UniversalOrbit& orbit, double dt) {
  const double mu = orbit.mu, beta = orbit.beta, h2 = orbit.h2, h = std::sqrt(h2);
  const double e = std::sqrt(1.0 - beta * h2 / (mu * mu)), q = h2 / (mu * (1.0 + e));
  const UniversalOrbit from_periapsis{mu, q, 0.0, beta, mu * e, h2};
  // e sinh F = r . v (-beta)^1/2/mu. Where F is small, e sinh F - F by G_3.
  const double root = std::sqrt(-beta), e_sinh = orbit.eta * root / mu, F = std::asinh(e_sinh / e);
  const double since_periapsis = std::abs(F) > 1.0
                                     ? mu * (e_sinh - F) / (-beta * root)
                                     : (q * F + mu * e * universal_functions(-1.0, F).G3 / -beta) / root;
  const double x = (h2 / mu - orbit.r) / e, y = h * orbit.eta / (mu * e), size = std::hypot(x, y);
  const Eigen::Vector3d radial = start.r / orbit.r;
  const Eigen::Vector3d across = start.r.cross(start.v).cross(radial) / h;
  const Eigen::Vector3d P = (x * radial - y * across) / size, Q = (y * radial + x * across) / size;

  const auto G = universal_functions(beta, universal_anomaly(from_periapsis, dt + since_periapsis));
  const double r = q + mu * e * G.G2;
  return {(q - mu * G.G2) * P + h * G.G1 * Q, -mu * G.G1 / r * P + (1.0 - beta * G.G2) * h / r * Q};
}

// Phi is symplectic: Phi^-1 = -J Phi^T J, J = [0 1; -1 0].
StateTransition symplectic_inverse(const StateTransition& Phi) {
  StateTransition result;
  result << Phi.bottomRightCorner<3, 3>().transpose(), -Phi.topRightCorner<3, 3>().transpose(),
      -Phi.bottomLeftCorner<3, 3>().transpose(), Phi.topLeftCorner<3, 3>().transpose();
  return result;
}

// The transition from start to end, a time dt later on the same orbit, by the way outbound from end: inbound
// its terms would cancel.
StateTransition inbound_transition(const OrbitNumbers& end, const UniversalOrbit& orbit, double dt) {
  StateTransition outbound;
  moved(end, universal_orbit(orbit.mu, orbit.beta, end), -dt, &outbound);
  return symplectic_inverse(outbound);
}

}  // namespace

OrbitNumbers propagated(const Caller& name, double mu, const OrbitNumbers& start, double dt,
                        StateTransition* transition) {
  const double r = start.r.norm(), v2 = start.v.squaredNorm();
  if (!(mu > 0.0 && std::isfinite(mu)))
    throw BadInput(name() + "mu is " + text(mu) + " m^3/s^2; it must be finite and positive");
  if (!std::isfinite(dt)) throw BadInput(name() + "dt is " + text(dt) + " s");
  if (!(r > 0.0 && std::isfinite(r * v2 / mu) && std::isfinite(mu / r)))
    throw BadInput(name() + "|r| is " + text(r) + " m, |v| " + text(std::sqrt(v2)) + " m/s, no orbit");

  const UniversalOrbit orbit = universal_orbit(mu, 2.0 * mu / r - v2, start);
  if (orbit.beta > 0.0 && std::abs(dt) * std::numeric_limits<double>::epsilon() > period_of(orbit))
    throw BadInput(name() + "dt is " + text(dt) + " s, and its rounding more than the period, " +
                   text(period_of(orbit)) + " s");
  OrbitNumbers end;
  const double to_periapsis = orbit.beta < 0.0 && orbit.h2 > 0.0 ? -time_since_periapsis(orbit) : 0.0;
  if (to_periapsis * dt > 0.0 && std::abs(to_periapsis) < 2.0 * std::abs(dt)) {
    end = moved_by_periapsis(start, orbit, dt);
    if (transition && std::abs(dt) <= std::abs(to_periapsis)) {
      *transition = inbound_transition(end, orbit, dt);
    } else if (transition) {
      const OrbitNumbers periapsis = moved_by_periapsis(start, orbit, to_periapsis);
      moved(periapsis, universal_orbit(mu, orbit.beta, periapsis), dt - to_periapsis, transition);
      *transition *= inbound_transition(periapsis, orbit, to_periapsis);
    }
  } else {
    end = moved(start, orbit, dt, transition);
  }
  if (!(end.r.allFinite() && end.v.allFinite() && (!transition || transition->allFinite())))
    throw BadInput(name() + "dt is " + text(dt) + " s: the motion then is not finite");
  return end;
}

}  // namespace vectrix::detail
