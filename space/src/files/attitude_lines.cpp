#include "attitude_lines.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <vectrix/frames/errors.hpp>

#include "kvn.hpp"

namespace vectrix::detail {

std::string type_name(AttitudeType type, const std::string& version) {
  if (type == AttitudeType::quaternion) return "QUATERNION";
  if (type == AttitudeType::quaternion_derivative) return "QUATERNION/DERIVATIVE";
  if (type == AttitudeType::euler_angle) return "EULER_ANGLE";
  if (type == AttitudeType::angular_velocity) return "ANGVEL";
  return has_direction(version) ? "QUATERNION/RATE" : "QUATERNION/ANGVEL";
}

std::optional<RateFrame> rate_frame_named(const AttitudeLines& lines, const std::string& word) {
  const std::string capitals = upper_case(word);
  if (capitals == lines.frame_keyword + "_A" || capitals == upper_case(lines.ref_frame_a))
    return RateFrame::a;
  if (capitals == lines.frame_keyword + "_B" || capitals == upper_case(lines.ref_frame_b))
    return RateFrame::b;
  return std::nullopt;
}

std::string norm_fault(double norm) {
  constexpr double most = 0.01;  // of quaternions with two decimals
  if (std::abs(norm - 1.0) <= most) return "";
  return "of a quaternion whose norm is " + text(norm) + "; it may differ from 1 by " + text(most);
}

std::optional<std::array<int, 3>> parse_euler_sequence(const std::string& text) {
  if (text.size() != 3) return std::nullopt;
  std::array<int, 3> axes{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto digit = std::string_view{"123"}.find(text[i]), letter = std::string_view{"XYZ"}.find(text[i]);
    if (digit == std::string_view::npos && letter == std::string_view::npos) return std::nullopt;
    axes[i] = static_cast<int>(std::min(digit, letter));
    if (i > 0 && axes[i] == axes[i - 1]) return std::nullopt;
  }
  return axes;
}

}  // namespace vectrix::detail
