#pragma once

#include <cstddef>
#include <vector>

/// How often a test repeats what it does. The sanitizers look for errors in memory, which a tenth of the
/// repetitions shows as well, and take fifty times as long for each. The optimised runs do them all.
namespace vectrix_test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VECTRIX_TEST_SANITIZED
#endif
#endif
#ifdef VECTRIX_TEST_SANITIZED
constexpr int repetitions_skipped = 10;
#else
constexpr int repetitions_skipped = 1;
#endif

constexpr int trials(int wanted) {
  return wanted / repetitions_skipped;
}

template <class T> std::vector<T> tried(const std::vector<T>& all) {
  std::vector<T> some;
  for (std::size_t i = 0; i < all.size(); i += repetitions_skipped) some.push_back(all[i]);
  return some;
}

}  // namespace vectrix_test
