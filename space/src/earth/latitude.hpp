#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>

namespace vectrix::detail {

/// The latitude, rad. `name` starts the message of a BadInput for one that is none.
inline double checked_latitude(const std::string& name, const Geodetic& place) {
  const double latitude = place.latitude.value();
  if (!(std::abs(latitude) <= std::numbers::pi / 2.0)) {
    throw BadInput(name + ": the latitude " + text(latitude) + " rad is not in [-pi/2, pi/2]");
  }
  return latitude;
}

}  // namespace vectrix::detail
