#pragma once

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/coincident.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {

namespace earth {

/// True equator, mean equinox of date: the frame of two-line element sets and SGP4. z is along the celestial
/// intermediate pole; x differs from that of TrueOfDate by the equation of the equinoxes. SGP4 takes it for
/// inertial: it turns by 8e-12 rad/s relative to Gcrf, by precession, 5e-5 m/s in a low orbit. A position in
/// it taken for one in Gcrf is off there by 1.7 km for each year since 2000: 44 km in 2026.
struct Teme : inertial_frame {};

}  // namespace earth

/// The rotation of the Earth in TEME, by the sidereal time of 1982, as SGP4 has it:
///     R_itrf^teme = R3(-GMST82(UT1)) W(x, y, s'),    W = R_itrf^tirf
///     w_ti^i = dGMST82/dUT1 (1 + d(UT1-TAI)/dTAI) along the celestial intermediate pole, and polar motion
/// with R3 as in earth_rotation() (Vallado, Crawford, Hujsak, Kelso: Revisiting Spacetrack Report #3, 2006,
/// appendix C).
VECTRIX_EXPORT MovingDcm<earth::Teme, earth::Itrf> teme_from_itrf(
    const Epoch& epoch, const EarthOrientationParameters& parameters);
template <class Given>
auto teme_from_itrf(  // an Epoch, and orientation.parameters(epoch) or an EarthMotion
    const Epoch&, const Given&) -> Refused = delete;

/// The same as an edge of a frame graph, edge(teme(orientation)); of an EarthMotion it is a thousand times
/// faster.
inline auto teme(const EarthOrientation& orientation) {
  return [orientation](const Epoch& epoch) {
    return coincident(teme_from_itrf(epoch, orientation.parameters(epoch)));
  };
}

}  // namespace vectrix
