#pragma once

#include <vectrix/space/time/epoch.hpp>

#include "pole_turn.hpp"

namespace vectrix::detail {

/// X and Y of the celestial intermediate pole in GCRF and the locator s of the origin, rad, by eraXy06 and
/// eraS06, and their derivatives by TT, from three calls 864 s apart: to 2e-17 rad/s and 1e-23 rad/s^2.
struct CelestialPole {
  Varying X, Y, s;
};
CelestialPole celestial_pole(const JulianDate<scale::Tt>& tt);

}  // namespace vectrix::detail
