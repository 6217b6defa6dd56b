#pragma once

#include <algorithm>
#include <cstddef>
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

template <class T> std::vector<T> tried(const std::vector<T>& all) {
  std::vector<T> some;
  for (std::size_t i = 0; i < all.size(); i += one_in) some.push_back(all[i]);
  return some;
}

}  // namespace vectrix_test
