#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <vectrix/kinematics/named/nearest_name.hpp>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

/// Where something stands in a scenario file; lines and columns are counted from 1.
struct Place {
  std::string file;
  std::size_t line = 1, column = 1;

  /// "file:3"
  [[nodiscard]] std::string line_text() const { return file + ':' + std::to_string(line); }
  /// "file:3:7"
  [[nodiscard]] std::string text() const { return line_text() + ':' + std::to_string(column); }
};

/// Throws BadInput: "file:3:7: why".
[[noreturn]] inline void refuse(const Place& place, const std::string& why) {
  throw BadInput(place.text() + ": " + why);
}

/// "a, b, c"
template <class Names> std::string listed(const Names& names) {
  std::string all;
  for (const std::string_view name : names) all.append(all.empty() ? "" : ", ").append(name);
  return all;
}

/// What to write instead of an unknown name: "; the nearest is 'a'", or else "; there are: a, b, c".
template <class Names> std::string instead_of(std::string_view wanted, const Names& names) {
  const std::string_view nearest = detail::nearest_name(wanted, names);
  if (!nearest.empty()) return "; the nearest is '" + std::string(nearest) + "'";
  const std::string all = listed(names);
  return all.empty() ? "; there is none" : "; there are: " + all;
}

}  // namespace vectrix::cli
