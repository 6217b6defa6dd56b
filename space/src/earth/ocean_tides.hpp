#pragma once

#include <Eigen/Core>

#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// The variations of x, y (rad) and UT1 (s) by ocean tides of a day and half a day: rows. Columns: the
/// values, and their first and second derivatives by time, 1/s. Day and half day are those of UT1.
Eigen::Matrix3d ocean_tides(const Epoch& epoch, const Quantity<si::time>& ut1_minus_tai);

}  // namespace vectrix::detail
