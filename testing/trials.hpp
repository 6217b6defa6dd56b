#pragma once

#include <algorithm>
#include <cstddef>
#include <ranges>
#include <vector>

/// How often a test repeats what it does. The sanitizers look for errors in memory, which a tenth of the
/// repetitions shows as well, and take fifty times as long for each. The optimised runs do them all.
namespace vectrix_test {

#ifdef VECTRIX_SANITIZED
constexpr int one_in = 10;
#else
constexpr int one_in = 1;
#endif

/// At least one.
constexpr int trials(int wanted) {
  return std::max(1, wanted / one_in);
}

/// The first of each ten.
template <std::ranges::forward_range List>
std::vector<std::ranges::range_value_t<List>> tried(const List& all) {
  std::vector<std::ranges::range_value_t<List>> some;
  std::size_t i = 0;
  for (const auto& one : all)
    if (i++ % one_in == 0) some.push_back(one);
  return some;
}

}  // namespace vectrix_test
