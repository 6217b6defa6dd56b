#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace vectrix::cli {

/// What a page holds, read back without the code that writes it.

inline std::string unbase64(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::uint32_t digit = c >= 'a'   ? static_cast<std::uint32_t>(c - 'a') + 26
                                : c >= 'A' ? static_cast<std::uint32_t>(c - 'A')
                                : c >= '0' ? static_cast<std::uint32_t>(c - '0') + 52
                                : c == '+' ? 62
                                           : 63;
    group = group << 6U | digit;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> static_cast<unsigned>(bits) & 255U);
  }
  return bytes;
}

template <class Number> std::vector<Number> numbers_of(const std::string& base64) {
  const std::string bytes = unbase64(base64);
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

/// What stands between the two texts, after the first place of `after`.
inline std::string text_between(const std::string& text, const std::string& after, const std::string& from,
                                const std::string& until) {
  const auto place = text.find(after);
  const auto start = place == std::string::npos ? place : text.find(from, place);
  if (start == std::string::npos) throw std::runtime_error("the page has no " + from + " after " + after);
  const auto begin = start + from.size();
  return text.substr(begin, text.find(until, begin) - begin);
}

inline std::vector<double> page_times(const std::string& page, const std::string& plot) {
  return numbers_of<double>(text_between(page, "\"title\":\"" + plot + '"', "\"seconds\":\"", "\""));
}
inline std::vector<double> page_values(const std::string& page, const std::string& curve) {
  const std::string named = "\"name\":\"" + curve + '"';
  const double offset = std::stod(text_between(page, named, "\"offset\":", ","));
  std::vector<double> values;
  for (const float x : numbers_of<float>(text_between(page, named, "\"values\":\"", "\"")))
    values.push_back(static_cast<double>(x) + offset);
  return values;
}

}  // namespace vectrix::cli
