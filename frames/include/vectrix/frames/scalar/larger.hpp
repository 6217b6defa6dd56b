#pragma once

namespace vectrix::detail {

/// The larger of two numbers, and NaN if one is: std::max(x, NaN) is x, so that a largest error would hide
/// it.
template <class S> S larger(const S& a, const S& b) {
  return a > b || a != a ? a : b;
}

}  // namespace vectrix::detail
