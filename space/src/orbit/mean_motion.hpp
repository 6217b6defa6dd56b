#pragma once

#include <vectrix/frames/units.hpp>

namespace vectrix::detail {

/// rev/day: the semi-major axis is 6387 km, less than 10 km above the equator.
inline constexpr double fastest_mean_motion = 17.0;
/// B* per Earth radius: five times that of a bare foil 6 micrometres thick, 120 m^2/kg.
inline constexpr double largest_bstar = 100.0;
/// rev/day^2, rev/day^3: half the derivative of the mean motion and a sixth of the second, as they are
/// published. The columns of the first have no digit before the point; the second is below 0.1 in the last
/// orbits of all.
inline constexpr double largest_half_rate = 1.0, largest_sixth_of_second_rate = 1.0;

inline constexpr double hours_of_a_day = 24.0;
inline constexpr auto rev_per_hour = si::revolution / si::hour;

/// Of revolutions per day. Divided by 24 it is in revolutions per hour, which rounds once.
inline Quantity<si::angular_velocity> mean_motion(double revolutions) {
  return convert<si::angular_velocity>(revolutions / hours_of_a_day * rev_per_hour);
}

}  // namespace vectrix::detail
