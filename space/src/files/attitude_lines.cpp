#include "attitude_lines.hpp"

#include <algorithm>
#include <string_view>

namespace vectrix::detail {

std::string type_name(AttitudeType type, const std::string& version) {
  if (type == AttitudeType::quaternion) return "QUATERNION";
  if (type == AttitudeType::euler_angle) return "EULER_ANGLE";
  return has_direction(version) ? "QUATERNION/RATE" : "QUATERNION/ANGVEL";
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
