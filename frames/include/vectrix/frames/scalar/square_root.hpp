#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace vectrix::detail {

/// The root of x >= 0. For double by Eigen's packet operation: for std::sqrt the compiler also emits a call
/// for x < 0, which sets errno, and saves all registers around it.
template <class S> S square_root(const S& x) {
  if constexpr (std::is_same_v<S, double>) {
    return Eigen::Array<S, 2, 1>(x, x).sqrt()[0];
  } else {
    using std::sqrt;
    return sqrt(x);
  }
}

}  // namespace vectrix::detail
