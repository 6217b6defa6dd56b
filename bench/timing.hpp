#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bench {

// Makes the compiler assume that `value` is read and all memory is written.
template <class T> void keep(const T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace bench
