#pragma once

#include <vectrix/frames/dcm.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

namespace earth {

/// Mean equator and equinox of date: with bias and precession, without nutation, which is up to 20 arcsec.
struct MeanOfDate : moving_frame {};

}  // namespace earth

/// Bias and precession of IAU 2006, eraPmat06. The nutation of IAU 2006/2000A, eraNum06a, is what is missing
/// to TrueOfDate: true_of_date_from_gcrf(t) * inverse(mean_of_date_from_gcrf(t)).
VECTRIX_EXPORT Dcm<earth::MeanOfDate, earth::Gcrf> mean_of_date_from_gcrf(const Epoch& epoch);

}  // namespace vectrix
