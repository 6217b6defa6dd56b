#include "attitude_lines.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <vectrix/frames/errors.hpp>

#include "kvn.hpp"

namespace vectrix::detail {

namespace {

struct TypeName {
  AttitudeType type;
  const char *oldest, *newest;  // in version 1.0, and from 2.0 on
};
// What spins and the rates of Euler angles mean is said from version 2.0 on, in annex F.
constexpr TypeName type_names[] = {
    {AttitudeType::quaternion, "QUATERNION", "QUATERNION"},
    {AttitudeType::quaternion_derivative, "QUATERNION/DERIVATIVE", "QUATERNION/DERIVATIVE"},
    {AttitudeType::quaternion_rate, "QUATERNION/RATE", "QUATERNION/ANGVEL"},
    {AttitudeType::euler_angle, "EULER_ANGLE", "EULER_ANGLE"},
    {AttitudeType::euler_angle_derivative, nullptr, "EULER_ANGLE/DERIVATIVE"},
    {AttitudeType::euler_angle_rate, nullptr, "EULER_ANGLE/ANGVEL"},
    {AttitudeType::spin, nullptr, "SPIN"},
    {AttitudeType::spin_nutation, nullptr, "SPIN/NUTATION"},
    {AttitudeType::spin_nutation_momentum, nullptr, "SPIN/NUTATION_MOM"}};

}  // namespace

std::vector<AttitudeType> types_of(const std::string& version) {
  std::vector<AttitudeType> types;
  for (const TypeName& each : type_names) {
    if (!has_direction(version) || each.oldest) types.push_back(each.type);
  }
  return types;
}

std::string type_name(AttitudeType type, const std::string& version) {
  for (const TypeName& each : type_names) {
    if (each.type == type) return has_direction(version) && each.oldest ? each.oldest : each.newest;
  }
  return "ANGVEL";
}

std::vector<std::string_view> number_names(AttitudeType type, bool is_scalar_first) {
  std::vector<std::string_view> names, more;
  if (has_quaternion(type)) {
    names = {"Q1", "Q2", "Q3"};
    names.insert(is_scalar_first ? names.begin() : names.end(), "QC");
  } else if (has_euler_angles(type)) {
    names = {"ANGLE_1", "ANGLE_2", "ANGLE_3"};
  } else if (has_spin(type)) {
    names = {"SPIN_ALPHA", "SPIN_DELTA", "SPIN_ANGLE", "SPIN_ANGLE_VEL"};
  }
  if (type == AttitudeType::quaternion_derivative) {
    more = {"Q1_DOT", "Q2_DOT", "Q3_DOT"};
    more.insert(is_scalar_first ? more.begin() : more.end(), "QC_DOT");
  }
  if (type == AttitudeType::quaternion_rate) more = {"X_RATE", "Y_RATE", "Z_RATE"};
  if (type == AttitudeType::euler_angle_derivative) more = {"ANGLE_1_DOT", "ANGLE_2_DOT", "ANGLE_3_DOT"};
  if (type == AttitudeType::euler_angle_rate) more = {"ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z"};
  if (type == AttitudeType::spin_nutation) more = {"NUTATION", "NUTATION_PER", "NUTATION_PHASE"};
  if (type == AttitudeType::spin_nutation_momentum)
    more = {"MOMENTUM_ALPHA", "MOMENTUM_DELTA", "NUTATION_VEL"};
  names.insert(names.end(), more.begin(), more.end());
  return names;
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
