#pragma once

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

// The three factors of the rotation of the Earth, as edges with rates (IERS Conventions 2010, chapter 5).

/// The celestial intermediate pole has the direction (X + dX, Y + dY) in Gcrf, by eraXy06 and eraS06:
///     R_cirf^gcrf = Q(X + dX, Y + dY, s)    eraC2ixys
/// w_gc^c is the motion of the pole, below 1e-11 rad/s. It has no component along the pole, but for 1e-17
/// rad/s by the offsets, which s leaves out.
VECTRIX_EXPORT MovingDcm<earth::Gcrf, earth::Cirf> gcrf_from_cirf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);

/// The turn of the day, by eraEra00, with R3 as in earth_rotation():
///     R_tirf^cirf = R3(-ERA(UT1)),    w_ct^t = dERA/dUT1 (1 + d(UT1-TAI)/dTAI) along z
VECTRIX_EXPORT MovingDcm<earth::Cirf, earth::Tirf> cirf_from_tirf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);

/// Polar motion, by eraPom00 and eraSp00:
///     R_itrf^tirf = W(x, y, s') = R3(-s') R2(x) R1(y),    R3 as in earth_rotation(), R2 and R1 alike
///     w_ti^i = (-dy/dt, -dx/dt cos y, -dx/dt sin y)
VECTRIX_EXPORT MovingDcm<earth::Tirf, earth::Itrf> tirf_from_itrf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);

}  // namespace vectrix
