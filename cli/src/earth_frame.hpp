#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// The axes of a frame with the centre of the Earth as its origin, which move as a function of time alone.
struct EarthAxes : moving_frame {};
/// R_axes^gcrf and the rate of the axes relative to GCRF, in the axes.
using EarthFrame = std::function<MovingDcm<earth::Gcrf, EarthAxes>(const Epoch&)>;

/// The one name here of such a frame; nothing for another one.
///     GCRF (ICRF), EME2000 (J2000)
///     TEME (TEMEOFDATE)            true equator, mean equinox of date
///     TOD, MOD (also ..._EARTH)    true or mean equator and equinox of date, by IAU 2006/2000A
///     CIRF, TIRF                   with the intermediate pole, and the origins without rotation
///     ITRF, of any year
std::optional<std::string> earth_frame_name(const std::string& name);
/// The name that `what` states. Throws BadInput, with the nearest one, for another frame.
std::string stated_earth_frame(const std::string& what, const std::string& name);
/// "EME2000, J2000, GCRF, ..."
std::string earth_frame_names();

/// What its axes are, if they are of date: "true equator, mean equinox of date"; "" of another.
std::string axes_of_date(const std::string& frame);
/// Whether the frame depends on what is observed of the Earth: CIRF, TIRF, ITRF.
bool is_observed(const std::string& frame);

/// Throws BadInput for --orientation, unless the frame that --frame states or the one before, of which the
/// words are, is observed.
void require_observed(const std::string& stated, const std::string& before, const std::string& words);
/// Whether the axes turn by less than 1e-11 rad/s, with precession and nutation or not at all.
bool is_slow(const std::string& frame);

/// At the times of the span, of a frame by its name here. Throws BadInput, which begins with `needed`,
/// without the orientation of the Earth of which an observed frame is.
EarthFrame earth_frame(const std::string& name, const TimeSpan& span,
                       const std::optional<EarthOrientation>& orientation, const std::string& needed);

/// The axes in which something is given, and those in which it is to be.
struct OldAxes : moving_frame {};
struct NewAxes : moving_frame {};
/// R_new^old and the rate of the old axes relative to the new ones, in the old ones. Throws BadInput as
/// earth_frame(), of `file`.
std::function<MovingDcm<NewAxes, OldAxes>(const Epoch&)> turn_of_axes(
    const std::string& before, const std::string& after, const TimeSpan& span,
    const std::optional<EarthOrientation>& orientation, const std::string& file);

}  // namespace vectrix::cli
