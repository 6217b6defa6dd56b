#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace vectrix::cli {

/// The text as a browser is to show it: with <, >, & and " as entities, and control characters as \x00.
std::string escaped(std::string_view text);
/// <name attribute="value">inside</name>; the values are escaped, the inside is HTML already.
std::string element(std::string_view name,
                    std::initializer_list<std::pair<std::string_view, std::string>> attributes,
                    std::string_view inside);
inline std::string element(std::string_view name, std::string_view inside) {
  return element(name, {}, inside);
}

/// A text of JSON that may stand in a script element: < is \u003c.
std::string json_text(std::string_view text);
/// "[1,2]"
std::string json_list(std::span<const double> numbers);

/// Numbers as base64 of their bytes, the lowest first.
std::string base64(std::span<const float> numbers);
std::string base64(std::span<const double> numbers);

}  // namespace vectrix::cli
