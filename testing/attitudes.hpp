#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>
#include <vectrix/frames/frame.hpp>

#include "testing/generators.hpp"

/// Shared by the tests of rotations: frames, attitudes of every regime, and the text of an error.
namespace vectrix_test {

struct Gcrf : vectrix::inertial_frame {};
struct Itrf : vectrix::moving_frame {};
struct Ground : vectrix::moving_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
template <int I> struct Wheel : vectrix::moving_frame {};

/// The spacing of doubles at 1.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Two or three products of rotations, whose entries are at most 1: each product adds three roundings.
inline constexpr double rounding = 16 * epsilon;
/// Far above rounding: a transposed or reversed product of generic rotations differs by more.
inline constexpr double visible = 1e-2;

/// Half turns about axes and diagonals, almost half turns, small turns; each also with the other sign.
inline std::vector<Eigen::Quaterniond> hard_attitudes() {
  std::vector<Eigen::Quaterniond> list{Eigen::Quaterniond::Identity()};
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const Eigen::Vector3d n = Eigen::Vector3d(x, y, z).normalized();
        list.emplace_back(0.0, n.x(), n.y(), n.z());
        for (const double distance : {1e-15, 1e-12, 1e-8, 1e-4}) {
          list.emplace_back(Eigen::AngleAxisd(std::numbers::pi - distance, n));
          list.emplace_back(Eigen::AngleAxisd(distance, n));
        }
        list.emplace_back(Eigen::AngleAxisd(std::numbers::pi / 2, n));
        list.emplace_back(Eigen::AngleAxisd(2 * std::numbers::pi / 3, n));
      }
    }
  }
  const std::size_t count = list.size();
  for (std::size_t i = 0; i < count; ++i) list.emplace_back(-list[i].coeffs());
  return list;
}

/// Uniform in [-1, 1], in steps of 1e-6.
rc::Gen<double> coordinate();
rc::Gen<Eigen::Vector3d> triple();
/// Unit quaternions of all regimes: identity and the hard list, angles near 1e-8, generic.
rc::Gen<Eigen::Quaterniond> attitude();
/// Eigen's matrix of that quaternion, the reference for a rotation.
rc::Gen<Eigen::Matrix3d> rotation_matrix();

/// The largest difference of two entries; not a number where one is none. A loop over numbers: Eigen's would
/// be compiled anew for each pair of expressions.
template <class Left, class Right>
double distance(const Eigen::MatrixBase<Left>& left, const Eigen::MatrixBase<Right>& right) {
  static_assert(int(Left::RowsAtCompileTime) == int(Right::RowsAtCompileTime) &&
                int(Left::ColsAtCompileTime) == int(Right::ColsAtCompileTime));
  const typename Left::PlainObject l = left.derived();
  const typename Right::PlainObject r = right.derived();
  double largest = 0.0;
  for (Eigen::Index row = 0; row < l.rows(); ++row) {
    for (Eigen::Index column = 0; column < l.cols(); ++column) {
      const double difference = std::abs(l.coeff(row, column) - r.coeff(row, column));
      if (std::isnan(difference)) return difference;
      largest = std::max(largest, difference);
    }
  }
  return largest;
}

/// The text of the Error that `action` throws; empty if it throws none.
template <class Error, class Action> std::string message(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace vectrix_test

namespace rc {
extern template class Gen<Eigen::Vector3d>;
extern template class Gen<Eigen::Quaterniond>;
extern template class Gen<Eigen::Matrix3d>;
}  // namespace rc
