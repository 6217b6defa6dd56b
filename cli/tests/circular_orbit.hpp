#pragma once

#include <cmath>

#include "flown_orbit.hpp"

namespace vectrix::cli {

/// A low circular orbit in the axes of any frame, so many seconds after its node; its plane leans by 1 rad.
template <Frame A> PointMotion<A, Satellite, A> circular_orbit(double seconds) {
  constexpr double r = 7e6, n = 1.08e-3;
  const double u = n * seconds;
  const Eigen::Vector3d x(1.0, 0.0, 0.0), y(0.0, std::cos(1.0), std::sin(1.0));
  return point_motion(of<Satellite>, relative_to<A>, observed_from<A>,
                      vector<si::length>(in<A>, r * (std::cos(u) * x + std::sin(u) * y)),
                      vector<si::velocity>(in<A>, r * n * (std::cos(u) * y - std::sin(u) * x)));
}

}  // namespace vectrix::cli
