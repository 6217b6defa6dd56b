#pragma once

namespace vectrix::detail {

/// A number and its first and second derivative by time.
struct Varying {
  double value, rate, second;
};

}  // namespace vectrix::detail
