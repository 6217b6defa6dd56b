#pragma once

#include <cmath>

#include "../taylor.hpp"

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

/// A number and its derivatives by time, with that of the acceleration or without. What depends on time is
/// written for double and for both.
using Jerking = Taylor<3>;
using Accelerating = Taylor<2>;
inline double value_of(double x) {
  return x;
}
template <std::size_t order> double value_of(const Taylor<order>& x) {
  return x.c[0];
}
/// x, from which whole turns are taken away.
inline double less_turns(double x, double reduced) {
  static_cast<void>(x);
  return reduced;
}
template <std::size_t order> Taylor<order> less_turns(Taylor<order> x, double reduced) {
  x.c[0] = reduced;
  return x;
}

/// Mean motion (Brouwer's), eccentricity, inclination, node, argument of perigee, mean anomaly.
template <class T> struct ElementsOf { T n, e, i, node, perigee, M; };
using Elements = ElementsOf<double>;

/// What the zonal harmonics change in a minute.
struct ZonalRates {
  double M, perigee, node;
};

inline double semi_major_axis(double n) {
  return std::cbrt(ke / n * (ke / n));
}
template <std::size_t order> Taylor<order> semi_major_axis(const Taylor<order>& n) {
  return power(n, -2.0 / 3.0, semi_major_axis(n.c[0]));
}

}  // namespace vectrix::detail::sgp4
