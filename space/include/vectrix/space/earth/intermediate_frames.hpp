#pragma once

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

/// The three factors of the rotation of the Earth, as edges with rates (IERS Conventions 2010, chapter 5).
/// The celestial intermediate pole has the direction (X + dX, Y + dY) in Gcrf; X, Y, s by eraXy06 and eraS06:
///     R_cirf^gcrf = Q(X + dX, Y + dY, s)         eraC2ixys
/// w_gc^c has no component along the pole, because Cirf has x at a non-rotating origin; up to 1e-17 rad/s by
/// the offsets, which s leaves out.
VECTRIX_EXPORT MovingDcm<earth::Gcrf, earth::Cirf> gcrf_from_cirf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);
///     R_tirf^cirf = R3(-ERA(UT1)),  w_ct^t = dERA/dUT1 (1 + d(UT1-TAI)/dTAI) along z    eraEra00
VECTRIX_EXPORT MovingDcm<earth::Cirf, earth::Tirf> cirf_from_tirf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);
///     R_itrf^tirf = W(x, y, s') = (R1(-y) R2(-x) R3(s'))^T,  with the rates of x and y    eraPom00, eraSp00
VECTRIX_EXPORT MovingDcm<earth::Tirf, earth::Itrf> tirf_from_itrf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);

}  // namespace vectrix
