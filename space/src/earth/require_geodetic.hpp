#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix::detail {

/// Throws BadInput unless the latitude is in [-pi/2, pi/2] and the longitude finite.
inline void require_angles(const Caller& name, double latitude, double longitude) {
  if (!(std::abs(latitude) <= std::numbers::pi / 2.0))
    throw BadInput(name() + "the latitude " + text(latitude) + " rad is not in [-pi/2, pi/2]");
  if (!std::isfinite(longitude))
    throw BadInput(name() + "the longitude " + text(longitude) + " rad is not finite");
}
/// The same, and the height finite.
inline void require_geodetic(const Caller& name, const Geodetic& place) {
  require_angles(name, place.latitude.angle.value(), place.longitude.value());
  const double height = place.height.value();
  if (!std::isfinite(height)) throw BadInput(name() + "the height " + text(height) + " m is not finite");
}

/// Throws BadInput unless the square of the position is finite, and not the centre of the Earth.
inline void require_place(const Caller& name, const Eigen::Vector3d& r) {
  if (!std::isfinite(r.squaredNorm())) {
    throw BadInput(name() + "the position (" + text(r.x()) + ", " + text(r.y()) + ", " + text(r.z()) +
                   ") m is not finite, or too far");
  }
  if (r.isZero(0.0)) throw BadInput(name() + "the centre of the Earth has no latitude");
}

/// In (-pi, pi], 0 on the axis.
inline double longitude_of(const Eigen::Vector3d& r) {
  return std::atan2(r.y() + 0.0, r.x() + 0.0);  // -0 becomes 0: longitude pi, not -pi
}

}  // namespace vectrix::detail
