#pragma once

#include <Eigen/Core>
#include <vector>
#include <vectrix/dynamics/multibody/spatial.hpp>

/// Between the numbers of the engine and those of the frames.
namespace vectrix::detail {

using Column3 = multibody::Column<double>;
using Square3 = multibody::Square<double>;

inline Column3 numbers(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}
inline Square3 numbers(const Eigen::Matrix3d& m) {
  return {numbers(Eigen::Vector3d(m.col(0))), numbers(Eigen::Vector3d(m.col(1))),
          numbers(Eigen::Vector3d(m.col(2)))};
}
/// The six numbers of a symmetric matrix.
inline multibody::Symmetric<double> symmetric(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}
inline Eigen::Vector3d eigen(const Column3& v) {
  return {v.x, v.y, v.z};
}
inline Eigen::Matrix3d eigen(const Square3& m) {
  Eigen::Matrix3d matrix;
  matrix << m.x.x, m.y.x, m.z.x, m.x.y, m.y.y, m.z.y, m.x.z, m.y.z, m.z.z;
  return matrix;
}
inline void append(std::vector<double>& numbers, const Eigen::Vector3d& v) {
  numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
}
inline Square3 transposed(const Square3& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// a^T b
inline Square3 transposed_times(const Square3& a, const Square3& b) {
  return {multibody::transposed_times(a, b.x), multibody::transposed_times(a, b.y),
          multibody::transposed_times(a, b.z)};
}

}  // namespace vectrix::detail
