#pragma once

#include <filesystem>
#include <string>

#include "orbit_record.hpp"
#include "plain_attitude.hpp"
#include "table_text.hpp"

namespace vectrix::cli {

/// What a viewer reads: .a for STK, .czml for Cesium.
inline bool is_viewer_name(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  return ending == ".a" || ending == ".czml";
}

/// An attitude file of STK: AttitudeTimeQuaternions, the scalar last, where R(q) takes coordinates from the
/// body to CoordinateAxes, J2000 or ICRF, and times are seconds from ScenarioEpoch. Quaternions have norm 1,
/// and the sign that is nearer to the one before.
std::string stk_attitude(const PlainAttitude& attitude);

/// A packet of CZML with the orientation of `object`: unitQuaternion, x, y, z, w, where R(q) takes
/// coordinates from the body to the axes of the Earth, which turn as without observations, UT1 = UTC. Packets
/// with one name are of one object: a document of its orbit has its position.
std::string czml_attitude(PlainAttitude attitude, const std::string& object);

/// A packet of CZML with the position and velocity of `object`, in m, INERTIAL of GCRF or FIXED of ITRF, with
/// the interpolation of the message. Throws BadInput for other frames, and for another centre than the Earth.
std::string czml_orbit(const OrbitRecord& orbit, const std::string& object);

}  // namespace vectrix::cli
