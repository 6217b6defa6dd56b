#pragma once

#include <vector>

#include "draw.hpp"

/// Forces and the points where they act; the expected moments are sums. Shared by the tests of moments and
/// wrenches.
namespace vectrix::test {

struct Camera : moving_frame {};

/// A force, or a linear momentum, at r.
struct Arrow {
  Vector3d r;
  Vector3d vector;
};

inline std::vector<Arrow> random_arrows(Draw& draw) {
  std::vector<Arrow> list;
  for (int i = 0; i < 5; ++i) list.push_back({draw.triple(), draw.triple()});
  return list;
}

/// The definition: sum of (r_k - p) x F_k.
inline Vector3d moment_about(const Vector3d& p, const std::vector<Arrow>& arrows) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& [r, F] : arrows) sum += (r - p).cross(F);
  return sum;
}
inline Vector3d sum_of(const std::vector<Arrow>& arrows) {
  Vector3d sum = Vector3d::Zero();
  for (const Arrow& arrow : arrows) sum += arrow.vector;
  return sum;
}

inline Vector<Body, si::force> force(const Vector3d& F) {
  return vector<si::force>(in<Body>, F);
}
inline Vector<Body, si::momentum> momentum(const Vector3d& p) {
  return vector<si::momentum>(in<Body>, p);
}
inline Vector<Body, si::torque> newton_metres(const Vector3d& M) {
  return vector<si::torque>(in<Body>, M);
}

}  // namespace vectrix::test
