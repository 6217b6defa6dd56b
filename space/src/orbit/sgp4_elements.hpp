#pragma once

#include <cmath>

/// SGP4 in its own units: minutes, radians, Earth radii. Sources of every formula here:
///     Hoots and Roehrich, Spacetrack Report No. 3, 1980
///     Hoots, Schumacher and Glover, History of Analytical Orbit Modeling in the U.S. Space Surveillance
///     System, J. Guidance, Control and Dynamics 27 (2), 2004
///     Vallado, Crawford, Hujsak and Kelso, Revisiting Spacetrack Report #3, AIAA 2006-6753
namespace vectrix::detail::sgp4 {

// WGS-72.
inline constexpr double earth_radius = 6378.135;  // km
inline constexpr double J2 = 1.082616e-3, J3 = -2.53881e-6, J4 = -1.65597e-6;
/// The square root of mu = 398600.8 km^3/s^2, in Earth radii^(3/2) per minute.
inline const double ke = 60.0 / std::sqrt(earth_radius * earth_radius * earth_radius / 398600.8);

/// Mean motion (Brouwer's), eccentricity, inclination, node, argument of perigee, mean anomaly.
struct Elements {
  double n, e, i, node, perigee, M;
};

/// What the zonal harmonics change in a minute.
struct ZonalRates {
  double M, perigee, node;
};

inline double semi_major_axis(double n) {
  return std::cbrt(ke / n * (ke / n));
}

}  // namespace vectrix::detail::sgp4
