#pragma once

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

namespace earth {

/// Mean equator and equinox of date: with bias and precession, without nutation, which is up to 20 arcsec.
struct MeanOfDate : moving_frame {};

}  // namespace earth

// The classical frames of the equinox, by the models of IAU 2006/2000A without observed offsets, as edges
// with rates. The rates are difference quotients over half an hour, below 1e-11 rad/s and within 1e-16.

/// Bias and precession, eraPmat06. The nutation, eraNum06a, is what is missing to TrueOfDate:
/// true_of_date_from_gcrf(t) * inverse(mean_of_date_from_gcrf(t)).
VECTRIX_EXPORT MovingDcm<earth::MeanOfDate, earth::Gcrf> mean_of_date_from_gcrf(const Epoch& epoch);

/// Bias, precession and nutation, eraPnm06a.
VECTRIX_EXPORT MovingDcm<earth::TrueOfDate, earth::Gcrf> true_of_date_from_gcrf(const Epoch& epoch);

/// Apparent sidereal time GST, eraGst06, and polar motion W = R_itrf^tirf:
///     R_true^itrf = W(x, y, s')^T R3(GST),    R3 as in earth_rotation()
/// With dX = dY = 0 the product with true_of_date_from_gcrf(t) is the inverse of earth_rotation() to 1.2e-11
/// rad, from 1973 to 2027.
VECTRIX_EXPORT MovingDcm<earth::Itrf, earth::TrueOfDate> itrf_from_true_of_date(
    const Epoch& epoch, const EarthOrientationParameters& parameters);

}  // namespace vectrix
