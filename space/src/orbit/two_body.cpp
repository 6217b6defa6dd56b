#include <cmath>
#include <numbers>

#include <vectrix/space/orbit/two_body.hpp>

#include "universal_kepler.hpp"

namespace vectrix::detail {
namespace {

using Gradient = Eigen::Matrix<double, 1, 6>;  // by (r, v) at the start

// The end of the orbit, r_end = f r + g v, v_end = fdot r + gdot v.
struct Lagrange {
  double f, g, fdot, gdot, r;

  Lagrange(const UniversalOrbit& o, const UniversalFunctions& G)
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
                              const UniversalFunctions& G, const Lagrange& end, double drift) {
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

}  // namespace

OrbitNumbers propagated(const std::string& name, double mu, const OrbitNumbers& start, double dt,
                        StateTransition* transition) {
  const double r = start.r.norm(), v2 = start.v.squaredNorm();
  if (!(mu > 0.0 && std::isfinite(mu)))
    throw BadInput(name + "mu is " + text(mu) + " m^3/s^2; it must be finite and positive");
  if (!std::isfinite(dt)) throw BadInput(name + "dt is " + text(dt) + " s");
  if (!(r > 0.0 && std::isfinite(r * v2 / mu) && std::isfinite(mu / r)))
    throw BadInput(name + "|r| is " + text(r) + " m, |v| " + text(std::sqrt(v2)) + " m/s, no orbit");

  const double beta = 2.0 * mu / r - v2;
  const UniversalOrbit orbit{mu, r, start.r.dot(start.v), beta, r * v2 - mu};
  double within = dt, drift = 0.0;
  if (beta > 0.0) {
    const double period = 2.0 * std::numbers::pi * mu / (beta * std::sqrt(beta));
    within = std::remainder(dt, period);
    drift = -1.5 * (dt - within) / beta;
  }
  const double s = universal_anomaly(orbit, within);
  const UniversalFunctions G = universal_functions(beta, s);
  const Lagrange end(orbit, G);
  const OrbitNumbers moved{end.f * start.r + end.g * start.v, end.fdot * start.r + end.gdot * start.v};
  if (!(end.r > 0.0 && moved.r.allFinite() && moved.v.allFinite()))
    throw BadInput(name + "after " + text(dt) + " s |r| is " + text(end.r) + " m; the motion ends there");
  if (transition) *transition = transition_of(start, orbit, s, G, end, drift);
  return moved;
}

}  // namespace vectrix::detail
