#pragma once

#include <functional>
#include <optional>
#include <string>

#include "attitude_record.hpp"
#include "flown_orbit.hpp"

namespace vectrix::cli {

/// The one name here of a frame relative to which an attitude may be given; nothing for another frame.
///     one of earth_frame_name(), or
///     of the orbit, r and v relative to GCRF, h = r x v:
///     LVLH (VVLH)        z along -r, y along -h        RTN (RSW, QSW, RIC)  x along r, z along h
///     TNW                x along v, z along h          NTW                  y along v, z along h
///     VNC                x along v, y along h
/// These as CCSDS has them (SANA, orbit-relative reference frames), also with _ROTATING; those that are
/// _INERTIAL are others.
std::optional<std::string> reference_name(const std::string& name);
/// "GCRF, ICRF, EME2000, ..."
const char* reference_names();
/// What the axes of one of the orbit are: "z along -r, y along -(r x v)"; "" of another.
std::string axes_of_reference(const std::string& reference);

/// How to state what a reference needs.
struct ReferenceWords {
  const char *orbit, *orientation;
};
inline constexpr ReferenceWords reference_options{"--tle, --omm, --oem or --spk", "--orientation FILE"};
inline constexpr ReferenceWords reference_keys{"[orbit]", "orientation = \"FILE\" in [earth]"};
/// Nothing if no file is given. Throws BadInput, with the file, if the orientation of the Earth is not known
/// from the first of the times to the last.
std::optional<EarthOrientation> read_orientation(const std::filesystem::path& file,
                                                 const std::vector<Epoch>& times);

/// R_gcrf^reference at a time of the span. Throws BadInput, with the file, for a frame of an orbit without
/// one, and an observed frame without the orientation of the Earth.
std::function<Eigen::Matrix3d(const Epoch&)> reference_motion(
    const std::string& file, const std::string& reference, const TimeSpan& span, const FlownOrbit& orbit,
    const std::optional<EarthOrientation>& orientation, const ReferenceWords& words);

/// Throws BadInput for a message about another centre than the Earth.
void require_earth(const AttitudeRecord& record);

/// Of an attitude relative to a frame that moves makes one relative to GCRF: in to_reference(), and
/// `reference`. What the file has stays as it is. Throws BadInput as reference_motion(), and for a message
/// about another centre than the Earth: of it are the orbits, and from there targets are seen.
void turn_to_gcrf(AttitudeRecord& record, const FlownOrbit& orbit,
                  const std::optional<EarthOrientation>& orientation, const ReferenceWords& words);

}  // namespace vectrix::cli
