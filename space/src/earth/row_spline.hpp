#pragma once

#include <Eigen/Core>
#include <vector>

#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix::detail {

/// Sets the rates of four rows or more to the slopes of the cubic spline through them: the second derivative
/// is continuous, and at the second row and the last but one the third derivative too.
void set_rates(const std::vector<Epoch>& epochs, std::vector<EarthOrientationParameters>& rows);

/// The cubic with the values and rates of two rows, at a time after the first; see EarthOrientation::curves.
Eigen::Matrix<double, 5, 3> cubic(const EarthOrientationParameters& left,
                                  const EarthOrientationParameters& right, const Quantity<si::time>& day,
                                  const Quantity<si::time>& after_left);

}  // namespace vectrix::detail
