#pragma once

#include <vectrix/frames/dcm.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

namespace earth {

/// Mean equator and equinox of J2000.0, also called J2000: inertial, 0.02 arcsec from Gcrf.
struct Eme2000 : inertial_frame {};

}  // namespace earth

/// The frame bias of IAU 2006, eraBp06: constant, so rigid_edge(eme2000_from_gcrf()) is an edge. With xi =
/// -16.617 mas, eta = -6.819 mas and da = -14.6 mas (IERS Conventions 2010, section 5.4.4), to first order
///     R_gcrf^eme = [1, da, -xi; -da, 1, -eta; xi, eta, 1]
VECTRIX_EXPORT Dcm<earth::Eme2000, earth::Gcrf> eme2000_from_gcrf();

}  // namespace vectrix
