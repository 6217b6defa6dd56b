#pragma once

#include <vectrix/space/sky/geocentric.hpp>

namespace vectrix::detail {

// At a date in TT, where ERFA asks for TDB: 1.7 ms move the Earth by 50 m, the Moon by 2 m. No year is
// refused.

/// Of the Sun relative to the Earth, by eraEpv00.
PlainMotion sun_motion(const JulianDate<scale::Tt>& tt);
/// Of the Moon relative to the Earth, by eraMoon98.
PlainMotion moon_motion(const JulianDate<scale::Tt>& tt);
/// Of the Earth relative to the barycentre of the solar system, by eraEpv00.
PlainMotion earth_motion(const JulianDate<scale::Tt>& tt);

/// Throws BadInput outside the years 1900 to 2099, for which eraEpv00 was made.
void require_series(const char* what, const Epoch& epoch);

}  // namespace vectrix::detail
