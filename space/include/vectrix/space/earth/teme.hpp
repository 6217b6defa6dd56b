#pragma once

#include <vectrix/frames/frame.hpp>

namespace vectrix::earth {

/// True equator, mean equinox of date, the frame of SGP4: z along the pole of date of IAU 1976 and 1980, x in
/// the equator at Greenwich mean sidereal time west of Greenwich. It turns with precession, by 8e-12 rad/s,
/// which SGP4 neglects. It is neither Gcrf, which is 40 km away in a low orbit, nor TrueOfDate.
struct Teme : inertial_frame {};

}  // namespace vectrix::earth
