#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <vectrix/space/files/attitude_ephemeris_segment.hpp>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

inline constexpr MessageKind attitude_ephemeris{
    "attitude ephemeris message", "CCSDS_AEM_VERS", {"1.0", "2.0"}};
inline constexpr const char* attitude_interpolation = "INTERPOLATION_METHOD";

/// Whether the version has ATTITUDE_DIR and QUATERNION_TYPE.
inline bool has_direction(const std::string& version) {
  return version == "1.0";
}
inline const char* rate_keyword(const std::string& version) {
  return has_direction(version) ? "RATE_FRAME" : "ANGVEL_FRAME";
}
std::string type_name(AttitudeType type, const std::string& version);
constexpr std::size_t numbers_in_line(AttitudeType type) {
  return type == AttitudeType::quaternion ? 4 : type == AttitudeType::quaternion_rate ? 7 : 3;
}

/// The axes, 0 to 2, of a sequence that is written as 321 or ZYX. Nothing if it is no sequence: an axis twice
/// in a row.
std::optional<std::array<int, 3>> parse_euler_sequence(const std::string& text);
/// Of a sequence that has been checked.
inline std::array<int, 3> euler_axes(const std::string& text) {
  return *parse_euler_sequence(text);
}

}  // namespace vectrix::detail
