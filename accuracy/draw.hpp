#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace vectrix::accuracy {

/// The inputs of a row. They are the same in every run and on every machine, because no C library function is
/// used whose last digit depends on the processor.
class Draw {
 public:
  /// Index of the sample, from 0.
  std::size_t index = 0;

  double uniform(double from, double to) { return from + (to - from) * unit(); }

  /// Each power of two is equally likely.
  double logarithmic(double from, double to) {
    const int lowest = std::ilogb(from);
    const auto powers = static_cast<std::uint64_t>(std::ilogb(to) - lowest + 1);
    for (;;) {
      const double x = std::ldexp(1.0 + unit(), lowest + static_cast<int>(engine_() % powers));
      if (x >= from && x <= to) return x;
    }
  }

  /// A vector of length 1, to rounding.
  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d v = cube(1.0);
      if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1.0) return v / v.norm();
    }
  }
  /// A vector with a length between the two.
  Eigen::Vector3d vector(double from, double to) { return logarithmic(from, to) * direction(); }

  Eigen::Vector3d cube(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half), z = uniform(-half, half);
    return {x, y, z};
  }

  /// A unit quaternion to rounding, scalar last: uniform over the rotations.
  Eigen::Vector4d quaternion() {
    for (;;) {
      const Eigen::Vector3d v = cube(1.0);
      const Eigen::Vector4d q(v.x(), v.y(), v.z(), uniform(-1.0, 1.0));
      if (q.squaredNorm() > 0.01 && q.squaredNorm() < 1.0) return q / q.norm();
    }
  }

 private:
  double unit() { return std::ldexp(static_cast<double>(engine_() >> 11U), -53); }

  std::mt19937_64 engine_{20221028};
};

}  // namespace vectrix::accuracy
