#pragma once

#include <rapidcheck/gtest.h>

#include <erfam.h>

#include <Eigen/Core>

#include <vectrix/space/time/epoch.hpp>

// Epochs for properties of the Earth's frames, and what compares them with ERFA's matrices.
namespace vectrix::earth_test {

using Rows = double[3][3];

inline Eigen::Matrix3d matrix_of(const Rows& rows) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&rows[0][0]);
}
inline double largest(const Eigen::Matrix3d& m) {
  return m.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

/// From -1 to 1.
inline double any_part() {
  return *rc::gen::inRange(-1'000'000, 1'000'001) * 1e-6;
}
/// Within 27 years of 2000.
inline Epoch any_epoch() {
  return Epoch::from_tt("2000-01-01T12:00:00") + any_part() * 27.0 * ERFA_DJY * ERFA_DAYSEC * si::second;
}

}  // namespace vectrix::earth_test
