#pragma once

#include <Eigen/Core>

#include <vectrix/space/caller.hpp>

namespace vectrix::detail {

/// The unit normal of WGS-84 at the point nearest to r, upwards, and the height of r above that point, m.
struct EllipsoidNormal {
  Eigen::Vector3d up;
  double height;
};
/// Throws BadInput for the centre of the Earth.
EllipsoidNormal normal_at(const Caller& name, const Eigen::Vector3d& r);

}  // namespace vectrix::detail
