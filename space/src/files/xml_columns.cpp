#include "xml_columns.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "attitude_lines.hpp"
#include "covariance_keyword.hpp"

namespace vectrix::detail {
namespace {

const char* angle_unit(std::string_view name) {
  if (name == "NUTATION_PER") return "s";
  return name.ends_with("_VEL") || name.ends_with("_DOT") || name.starts_with("ANGVEL") ? "deg/s" : "deg";
}

}  // namespace

std::optional<XmlLine> attitude_line(const std::function<std::string(const char*)>& word,
                                     const std::string& version) {
  const bool is_oldest = has_direction(version);
  const std::string type = word("ATTITUDE_TYPE");
  XmlLine line{"", {{"EPOCH"}}};
  if (is_oldest && type == "EULER_ANGLE") {
    const auto axes = parse_euler_sequence(word("EULER_ROT_SEQ"));
    if (!axes) return std::nullopt;
    line.element = "eulerAngle";
    for (const int axis : *axes)
      line.columns.push_back({std::string(1, "XYZ"[axis]) + "_ANGLE", "deg", "rotationAngles"});
    return line;
  }
  for (const auto& [angles, element] : {std::pair{AttitudeType::euler_angle, "eulerAngle"},
                                        {AttitudeType::euler_angle_derivative, "eulerAngleDerivative"},
                                        {AttitudeType::euler_angle_rate, "eulerAngleAngVel"},
                                        {AttitudeType::spin, "spin"},
                                        {AttitudeType::spin_nutation, "spinNutation"},
                                        {AttitudeType::spin_nutation_momentum, "spinNutationMom"}}) {
    if (is_oldest || type != type_name(angles, version)) continue;
    line.element = element;
    for (const std::string_view name : number_names(angles, false))
      line.columns.push_back({std::string{name}, angle_unit(name), ""});
    return line;
  }
  const bool is_alone = type == "QUATERNION", has_derivative = type == "QUATERNION/DERIVATIVE";
  if (!is_alone && !has_derivative && type != type_name(AttitudeType::quaternion_rate, version))
    return std::nullopt;
  const bool is_scalar_first = is_oldest && word("QUATERNION_TYPE") == "FIRST";
  const auto put_quaternion = [&](const std::string& ending, const std::string& unit,
                                  const std::string& group) {
    if (is_scalar_first) line.columns.push_back({"QC" + ending, unit, group});
    for (const char* component : {"Q1", "Q2", "Q3"})
      line.columns.push_back({component + ending, unit, group});
    if (!is_scalar_first) line.columns.push_back({"QC" + ending, unit, group});
  };
  put_quaternion("", "", "quaternion");
  line.element = is_alone         ? is_oldest ? "quaternionState" : "quaternionEphemeris"
                 : has_derivative ? "quaternionDerivative"
                 : is_oldest      ? "quaternionEulerRate"
                                  : "quaternionAngVel";
  if (has_derivative) put_quaternion("_DOT", "1/s", is_oldest ? "quaternionRate" : "quaternionDot");
  if (is_alone || has_derivative) return line;
  for (const char* axis : {"X", "Y", "Z"})
    line.columns.push_back({is_oldest ? std::string{axis} + "_RATE" : "ANGVEL_" + std::string{axis}, "deg/s",
                            is_oldest ? "rotationRates" : "angVel"});
  return line;
}

XmlLine orbit_line(bool has_acceleration) {
  XmlLine line{"stateVector", {{"EPOCH"}}};
  for (std::size_t i = 0; i < state_components.size(); ++i)
    line.columns.push_back({state_components[i], i < 3 ? "km" : "km/s"});
  if (has_acceleration) {
    for (const char* name : {"X_DDOT", "Y_DDOT", "Z_DDOT"}) line.columns.push_back({name, "km/s**2"});
  }
  return line;
}

const char* covariance_unit(std::size_t row, std::size_t column) {
  constexpr std::array units{"km**2", "km**2/s", "km**2/s**2"};
  return units.at((row < 3 ? 0U : 1U) + (column < 3 ? 0U : 1U));
}

}  // namespace vectrix::detail
