#pragma once

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>
#include <vector>

namespace vectrix::detail {

/// The number of characters to insert, remove or replace to turn one into the other (Levenshtein), ignoring
/// case.
inline std::size_t edits(std::string_view one, std::string_view other) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char a : one) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < other.size(); ++j) {
      const std::size_t replaced = diagonal + (same(a, other[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The nearest name, if at least half of its characters are right; else empty.
template <class Names> std::string_view nearest_name(std::string_view wanted, const Names& names) {
  std::string_view nearest;
  std::size_t fewest = static_cast<std::size_t>(-1);
  for (const std::string_view name : names) {
    const std::size_t count = edits(wanted, name);
    if (count >= fewest || 2 * count > std::max(wanted.size(), name.size())) continue;
    nearest = name;
    fewest = count;
  }
  return nearest;
}

}  // namespace vectrix::detail
