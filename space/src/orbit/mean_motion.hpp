#pragma once

#include <vectrix/frames/units.hpp>

namespace vectrix::detail {

/// rev/day; a satellite as fast as this is below the surface.
inline constexpr double fastest_mean_motion = 20.0;

inline constexpr double hours_of_a_day = 24.0;
inline constexpr auto rev_per_hour = si::revolution / si::hour;

/// Of revolutions per day. Divided by 24 it is in revolutions per hour, which rounds once.
inline Quantity<si::angular_velocity> mean_motion(double revolutions) {
  return convert<si::angular_velocity>(revolutions / hours_of_a_day * rev_per_hour);
}

}  // namespace vectrix::detail
