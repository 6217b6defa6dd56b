#pragma once

#include <string>

#include <vectrix/space/sky/chebyshev.hpp>

namespace vectrix::detail {

// At a date in TT, where ERFA asks for TDB: 1.7 ms move the Earth by 50 m, the Moon by 2 m. No year is
// refused.

struct BodySeries {
  const char* name;
  ChebyshevPieces::Series motion;  // relative to the Earth
};
BodySeries series_of(Body body);
/// Of the Earth relative to the barycentre of the solar system, by eraEpv00.
PlainMotion earth_motion(const JulianDate<scale::Tt>& tt);

/// Throws BadInput outside the years 1900 to 2099, for which eraEpv00 was made.
void require_series(const std::string& what, const Epoch& epoch);

}  // namespace vectrix::detail
