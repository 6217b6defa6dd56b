#pragma once

#include <vectrix/frames/units.hpp>
#include <vectrix/space/orbit/kepler_equation.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {

/// The mean elements of SGP4: what is left of an orbit when the theory has taken its periodic terms out. In
/// the theory, and only there, they lead back to a motion: Sgp4<Q>(elements, at_most(age)).at(epoch). They
/// are not osculating elements, from which they differ by several km in a low orbit, and have no conversion
/// to KeplerianElements. Angles are relative to the equator and equinox of earth::Teme.
struct MeanElements {
  Epoch epoch;
  Quantity<si::angular_velocity> mean_motion;  ///< as in two-line elements (Kozai's)
  double eccentricity;
  Quantity<si::angle> inclination, ascending_node, argument_of_perigee;
  MeanAnomaly mean_anomaly;
  /// B*, rho_0 c_D A/(2 m), in 1/m; two-line elements have it per Earth radius, bstar_unit.
  Quantity<unit_quotient<si::dimensionless, si::length>> bstar;
};

/// One per Earth radius of WGS-72: 0.28098e-4 * bstar_unit.
inline constexpr auto bstar_unit = 1.0 / (6378135.0 * si::metre);

}  // namespace vectrix
