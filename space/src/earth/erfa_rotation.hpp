#pragma once

#include <erfa.h>
#include <Eigen/Core>

#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix::detail {

using Rows = double[3][3];  // as ERFA has a matrix
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline RowMajor matrix_of(const Rows& rows) {
  return Eigen::Map<const RowMajor>(&rows[0][0]);
}

inline JulianDate<scale::Ut1> ut1_date(const Epoch& epoch, const EarthOrientationParameters& parameters) {
  return epoch.julian_date(scale::Ut1::minus_tai(parameters.ut1_minus_tai));
}

/// The rotation to ITRF from the frame whose z axis is the celestial intermediate pole. Its column 2 is that
/// pole in ITRF.
inline void set_polar_motion(const JulianDate<scale::Tt>& tt, const EarthOrientationParameters& parameters,
                             Rows& matrix) {
  eraPom00(parameters.pole_x.value(), parameters.pole_y.value(), eraSp00(tt.day, tt.fraction), matrix);
}

}  // namespace vectrix::detail
