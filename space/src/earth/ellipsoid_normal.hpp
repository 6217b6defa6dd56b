#pragma once

#include <Eigen/Core>

#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix::detail {

/// Of WGS-84, m.
inline constexpr double equatorial_axis = wgs84::semi_major_axis.value();
inline constexpr double polar_axis = equatorial_axis * (1.0 - wgs84::flattening);
inline constexpr double eccentricity_squared = wgs84::flattening * (2.0 - wgs84::flattening);

/// The unit normal of WGS-84 at the point nearest to r, upwards, and the height of r above that point, m.
struct EllipsoidNormal {
  Eigen::Vector3d up;
  double height;
};
/// Throws BadInput for the centre of the Earth.
EllipsoidNormal normal_at(const Caller& name, const Eigen::Vector3d& r);

}  // namespace vectrix::detail
