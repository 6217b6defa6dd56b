#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vectrix::cli {

/// The place, counted from 0, that the quantile has among so many values in their order: the first one that
/// at least so many percent of all do not exceed. Above 0 and at most 100 percent, of at least one value.
inline std::size_t place_of_quantile(double percent, std::size_t count) {
  constexpr double rounding = 1e-9;  // 99.7 percent of 1000 values are 997
  const double values = std::ceil(0.01 * percent * static_cast<double>(count) - rounding);
  return static_cast<std::size_t>(std::max(values, 1.0)) - 1;
}

/// The lower one of the two middle values of an even number. There is at least one value.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(place_of_quantile(50.0, values.size()));
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace vectrix::cli
