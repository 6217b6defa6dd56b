#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/space/files/attitude_ephemeris_segment.hpp>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

inline constexpr const char* attitude_interpolation = "INTERPOLATION_METHOD";
inline constexpr MessageKeyword attitude_keywords[] = {
    {"CLASSIFICATION", MessagePart::header, "2.0"},
    {"CREATION_DATE", MessagePart::header},
    {"ORIGINATOR", MessagePart::header},
    {"MESSAGE_ID", MessagePart::header, "2.0"},
    {"OBJECT_NAME"},
    {"OBJECT_ID"},
    {"CENTER_NAME"},
    {"REF_FRAME_A"},
    {"REF_FRAME_B"},
    {"ATTITUDE_DIR", MessagePart::metadata, "1.0", "1.0"},
    {"TIME_SYSTEM"},
    {"START_TIME"},
    {"USEABLE_START_TIME"},
    {"USEABLE_STOP_TIME"},
    {"STOP_TIME"},
    {"ATTITUDE_TYPE"},
    {"QUATERNION_TYPE", MessagePart::metadata, "1.0", "1.0"},
    {"EULER_ROT_SEQ"},
    {"RATE_FRAME", MessagePart::metadata, "1.0", "1.0"},
    {"ANGVEL_FRAME", MessagePart::metadata, "2.0"},
    {attitude_interpolation},
    {"INTERPOLATION_DEGREE"}};
inline constexpr MessageKind attitude_ephemeris{
    "attitude ephemeris message", "CCSDS_AEM_VERS", {"1.0", "2.0"}, attitude_keywords};

/// Whether the version has ATTITUDE_DIR and QUATERNION_TYPE.
inline bool has_direction(const std::string& version) {
  return version == "1.0";
}
inline const char* rate_keyword(const std::string& version) {
  return has_direction(version) ? "RATE_FRAME" : "ANGVEL_FRAME";
}
/// REF_FRAME_A or REF_FRAME_B.
constexpr const char* rate_frame_name(RateFrame frame) {
  return frame == RateFrame::a ? "REF_FRAME_A" : "REF_FRAME_B";
}
/// The types that an AEM of the version may have.
std::vector<AttitudeType> types_of(const std::string& version);
std::string type_name(AttitudeType type, const std::string& version);
constexpr bool has_quaternion(AttitudeType type) {
  return type == AttitudeType::quaternion || type == AttitudeType::quaternion_derivative ||
         type == AttitudeType::quaternion_rate;
}
constexpr bool has_euler_angles(AttitudeType type) {
  return type == AttitudeType::euler_angle || type == AttitudeType::euler_angle_derivative ||
         type == AttitudeType::euler_angle_rate;
}
constexpr bool has_spin(AttitudeType type) {
  return type == AttitudeType::spin || type == AttitudeType::spin_nutation ||
         type == AttitudeType::spin_nutation_momentum;
}
/// Whether the last three numbers are an angular velocity.
constexpr bool has_rate(AttitudeType type) {
  return type == AttitudeType::quaternion_rate || type == AttitudeType::euler_angle_rate ||
         type == AttitudeType::angular_velocity;
}
/// The names of the numbers in a line.
std::vector<std::string_view> number_names(AttitudeType type, bool is_scalar_first);
constexpr std::size_t numbers_in_line(AttitudeType type) {
  switch (type) {
    case AttitudeType::quaternion:
    case AttitudeType::spin:
      return 4;
    case AttitudeType::quaternion_derivative:
      return 8;
    case AttitudeType::quaternion_rate:
    case AttitudeType::spin_nutation:
    case AttitudeType::spin_nutation_momentum:
      return 7;
    case AttitudeType::euler_angle_derivative:
    case AttitudeType::euler_angle_rate:
      return 6;
    default:
      return 3;
  }
}

/// Which of the frames of the lines a word means: the keyword of one of them, such as REF_FRAME_A, or its
/// name. Nothing if it is another word.
std::optional<RateFrame> rate_frame_named(const AttitudeLines& lines, const std::string& word);
/// Why a quaternion of this norm is refused; empty if it is not.
std::string norm_fault(double norm);

/// The axes, 0 to 2, of a sequence that is written as 321 or ZYX. Nothing if it is no sequence: an axis twice
/// in a row.
std::optional<std::array<int, 3>> parse_euler_sequence(const std::string& text);
}  // namespace vectrix::detail
