#pragma once

namespace vectrix::detail {

/// The universal functions G_n(beta, s) = s^n c_n(beta s^2), c_n Stumpff's functions: for beta > 0
/// G_0 = cos(E), G_1 = sin(E)/sqrt(beta) with E = sqrt(beta) s, and so on; for beta < 0 hyperbolic; for beta
/// = 0 s^n/n!. Their laws:
///     1.  dG_n/ds = G_(n-1)      2.  dG_n/dbeta = (n G_(n+2) - s G_(n+1)) / 2
/// (Battin, An Introduction to the Mathematics and Methods of Astrodynamics, section 4.5)
struct UniversalFunctions {
  double G0, G1, G2, G3, G4, G5;
};
UniversalFunctions universal_functions(double beta, double s);

/// What Kepler's equation in universal variables needs of an orbit: distance r, eta = r . v, beta = mu/a,
/// zeta = mu - beta r and h^2 = |r x v|^2.
///     dt = r s + eta G_2 + zeta G_3,      r(s) = r + eta G_1 + zeta G_2 = d(dt)/ds > 0
struct UniversalOrbit {
  double mu, r, eta, beta, zeta, h2;
};

/// The root s of Kepler's equation for a finite dt, of at most half a period if beta > 0.
double universal_anomaly(const UniversalOrbit& orbit, double dt);

/// Of a hyperbola, beta < 0: the time since periapsis, to about 1e-8 of it.
double time_since_periapsis(const UniversalOrbit& orbit);

}  // namespace vectrix::detail
