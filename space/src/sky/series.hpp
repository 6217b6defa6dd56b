#pragma once

#include <vectrix/frames/errors.hpp>
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

/// Whether the epoch is in the years 1900 to 2099, for which eraEpv00 was made.
bool in_series(const Epoch& epoch);
/// Throws BadInput outside them. name() begins the message.
template <class Name> void require_series(const Name& name, const Epoch& epoch) {
  if (!in_series(epoch)) [[unlikely]] {
    throw BadInput(name() + ": the epoch " + epoch.tt(0) +
                   " TT is outside the years of the series, 1900 to 2099");
  }
}

}  // namespace vectrix::detail
