#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace vectrix::detail {

/// The root of x >= 0. Of a double by Eigen's packet: beside std::sqrt compilers keep a call for x < 0, to
/// set errno, and save every register that the call could spoil.
template <class S> S square_root(const S& x) {
  if constexpr (std::is_same_v<S, double>) {
    return Eigen::Array2d(x, x).sqrt()[0];
  } else {
    using std::sqrt;
    return sqrt(x);
  }
}

}  // namespace vectrix::detail
