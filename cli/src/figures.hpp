#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string>
#include <string_view>

namespace vectrix::cli {

inline constexpr double degrees = 180.0 / std::numbers::pi;  // per radian

/// Four digits.
inline std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}
/// Six decimals: of a degree, 4 milliarcseconds.
inline std::string decimals(double value) {
  char text[352];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}
/// So many decimals, without the sign of a number that is rounded to zero.
inline std::string with_decimals(double value, int count) {
  char digits[352];
  std::snprintf(digits, sizeof digits, "%.*f", count, value);
  const std::string text = digits;
  const bool is_minus_zero = text.front() == '-' && text.find_first_of("123456789") == std::string::npos;
  return is_minus_zero ? text.substr(1) : text;
}
inline std::string padded(std::string text, std::size_t width) {
  text.insert(0, width - std::min(width, text.size()), ' ');
  return text;
}
/// "1 window", "2 windows"
inline std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}
/// The beginning of a line of figures.
inline std::string label(std::string_view name, std::size_t width = 30) {
  std::string text = "  " + std::string(name);
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

}  // namespace vectrix::cli
