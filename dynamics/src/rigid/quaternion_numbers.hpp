#pragma once

#include <array>

namespace vectrix::detail {

/// Hamilton's product, scalar first.
template <class S> std::array<S, 4> product(const std::array<S, 4>& p, const std::array<S, 4>& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
          p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]};
}

}  // namespace vectrix::detail
