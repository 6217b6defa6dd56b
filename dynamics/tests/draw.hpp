#pragma once

#include <random>
#include <vectrix/frames/displacement.hpp>

#include "rigid_bodies.hpp"

/// Random numbers, points and positions shared by the tests of moments and inertias.
namespace vectrix::test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Hinge : named_point {};
struct Thruster : named_point {};

class Draw {
 public:
  explicit Draw(unsigned long seed) : random_(seed) {}

  double number() { return uniform_(random_); }
  Vector3d triple() { return {number(), number(), number()}; }
  Matrix3d rotation() { return Eigen::AngleAxisd(3.0 * number(), triple().normalized()).matrix(); }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

template <class P, class Q, class C = Body> Displacement<P, Q, In<C>> from_to(const Vector3d& r_pq) {
  return displacement(of<Q>, relative_to<P>, vector<si::length>(in<C>, r_pq));
}

}  // namespace vectrix::test
