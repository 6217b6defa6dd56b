#pragma once

#include <Eigen/Core>
#include <vector>
#include <vectrix/dynamics/multibody/spatial.hpp>

/// Between the numbers of the engine and those of the frames.
namespace vectrix::detail {

using Column3 = multibody::Column<double>;
using Square3 = multibody::Square<double>;

template <class S> multibody::Column<S> numbers(const Eigen::Matrix<S, 3, 1>& v) {
  return {v.x(), v.y(), v.z()};
}
template <class S> multibody::Square<S> numbers(const Eigen::Matrix<S, 3, 3>& m) {
  const auto column = [&m](Eigen::Index j) { return multibody::Column<S>{m(0, j), m(1, j), m(2, j)}; };
  return {column(0), column(1), column(2)};
}
/// The six numbers of a symmetric matrix.
inline multibody::Symmetric<double> symmetric(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
}
template <class S> Eigen::Matrix<S, 3, 1> eigen(const multibody::Column<S>& v) {
  return {v.x, v.y, v.z};
}
template <class S> Eigen::Matrix<S, 3, 3> eigen(const multibody::Square<S>& m) {
  Eigen::Matrix<S, 3, 3> matrix;
  matrix << m.x.x, m.y.x, m.z.x, m.x.y, m.y.y, m.z.y, m.x.z, m.y.z, m.z.z;
  return matrix;
}
template <class S> void append(std::vector<S>& numbers, const Eigen::Matrix<S, 3, 1>& v) {
  numbers.insert(numbers.end(), {v.x(), v.y(), v.z()});
}
template <class S> multibody::Square<S> transposed(const multibody::Square<S>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// a^T b
template <class S>
multibody::Square<S> transposed_times(const multibody::Square<S>& a, const multibody::Square<S>& b) {
  return {multibody::transposed_times(a, b.x), multibody::transposed_times(a, b.y),
          multibody::transposed_times(a, b.z)};
}

}  // namespace vectrix::detail
