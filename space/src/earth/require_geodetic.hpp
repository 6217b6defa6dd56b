#pragma once

#include <cmath>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/caller.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix::detail {

/// Throws BadInput unless the latitude is in [-pi/2, pi/2], and longitude and height are finite.
inline void require_geodetic(const Caller& name, const Geodetic& place) {
  const double latitude = place.latitude.value(), longitude = place.longitude.value(),
               height = place.height.value();
  if (!(std::abs(latitude) <= std::numbers::pi / 2.0))
    throw BadInput(name() + "the latitude " + text(latitude) + " rad is not in [-pi/2, pi/2]");
  if (!std::isfinite(longitude))
    throw BadInput(name() + "the longitude " + text(longitude) + " rad is not finite");
  if (!std::isfinite(height)) throw BadInput(name() + "the height " + text(height) + " m is not finite");
}

}  // namespace vectrix::detail
