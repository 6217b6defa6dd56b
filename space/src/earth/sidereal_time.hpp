#pragma once

#include <erfa.h>
#include <erfam.h>

#include <vectrix/space/time/julian_date.hpp>

namespace vectrix::detail {

/// dGMST82/dUT1, rad/s: a turn a day, and the derivative of the polynomial of Aoki et al. (1982), which
/// eraGmst82 evaluates.
inline double sidereal_rate(const JulianDate<scale::Ut1>& ut1) {
  const double T = ((ut1.day - ERFA_DJ00) + ut1.fraction) / ERFA_DJC;
  const double seconds_per_century = 8640184.812866 + T * (2.0 * 0.093104 - T * 3.0 * 6.2e-6);
  return ERFA_D2PI / ERFA_DAYSEC * (1.0 + seconds_per_century / (ERFA_DJC * ERFA_DAYSEC));
}

}  // namespace vectrix::detail
