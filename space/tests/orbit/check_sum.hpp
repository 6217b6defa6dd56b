#pragma once

#include <cstddef>
#include <string>

namespace vectrix {

/// The line of two-line elements with its check sum in column 69: digits count themselves, a minus sign 1. A
/// line of 68 characters gets the column; a shorter one stays as it is.
inline std::string summed(const std::string& line) {
  constexpr std::size_t digits = 68;
  if (line.size() < digits) return line;
  int sum = 0;
  for (std::size_t i = 0; i < digits; ++i)
    sum += line[i] == '-' ? 1 : line[i] >= '0' && line[i] <= '9' ? line[i] - '0' : 0;
  std::string result = line.substr(0, digits) + static_cast<char>('0' + sum % 10);
  if (line.size() > digits) result += line.substr(digits + 1);
  return result;
}

}  // namespace vectrix
