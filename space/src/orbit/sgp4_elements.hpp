#pragma once

#include <Eigen/Core>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

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

/// A number and its derivative by time. What depends on time is written for double and for Moving.
using Moving = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
inline double value_of(double x) {
  return x;
}
inline double value_of(const Moving& x) {
  return x.value();
}
/// The angle of the direction (x, y).
inline double angle_of(double y, double x) {
  return std::atan2(y, x);
}
// Eigen's atan2 of two Moving allocates.
inline Moving angle_of(const Moving& y, const Moving& x) {
  const double square = x.value() * x.value() + y.value() * y.value();
  return {std::atan2(y.value(), x.value()),
          (y.derivatives() * x.value() - x.derivatives() * y.value()) / square};
}
/// x, from which whole turns are taken away.
inline double less_turns(double x, double reduced) {
  static_cast<void>(x);
  return reduced;
}
inline Moving less_turns(const Moving& x, double reduced) {
  return {reduced, x.derivatives()};
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
inline Moving semi_major_axis(const Moving& n) {
  const double a = semi_major_axis(n.value());
  return {a, n.derivatives() * (-2.0 / 3.0 * a / n.value())};
}

}  // namespace vectrix::detail::sgp4
