#include <cmath>
#include <numbers>

#include <vectrix/space/earth/look_angles.hpp>

#include "turn.hpp"

namespace vectrix::detail {

LookAngles look_angles_of(const Caller& name, const Eigen::Vector3d& r) {
  const double range = scaled_norm(r);
  if (!(range > 0.0 && std::isfinite(range))) throw BadInput(name() + "the range is " + text(range) + " m");
  return {in_one_turn(std::atan2(r.x(), r.y())) * si::radian,
          std::atan2(r.z(), std::hypot(r.x(), r.y())) * si::radian, range * si::metre};
}

// In units of the range, so that no square overflows or underflows; only e and n may be much smaller.
MovingLookAngles look_angles_of(const Caller& name, const Eigen::Vector3d& r, const Eigen::Vector3d& v) {
  const LookAngles look = look_angles_of(name, r);
  const double h = std::hypot(r.x(), r.y()), range = look.range.value();
  if (h == 0.0) {
    throw BadInput(name() + "at (0, 0, " + text(r.z()) + ") m, in the " + (r.z() > 0.0 ? "zenith" : "nadir") +
                   ", azimuth and elevation have no rates");
  }
  const double sine = r.x() / h, cosine = r.y() / h;  // of the azimuth
  const double outward = sine * v.x() + cosine * v.y();
  const double azimuth_rate = (cosine * v.x() - sine * v.y()) / h;
  const double elevation_rate = (h / range * v.z() - r.z() / range * outward) / range;
  const double range_rate = h / range * outward + r.z() / range * v.z();
  if (!std::isfinite(azimuth_rate) || !std::isfinite(elevation_rate) || !std::isfinite(range_rate)) {
    throw BadInput(name() + "the rates overflow: the position is (" + text(r.x()) + ", " + text(r.y()) +
                   ", " + text(r.z()) + ") m, the velocity (" + text(v.x()) + ", " + text(v.y()) + ", " +
                   text(v.z()) + ") m/s");
  }
  const auto per_second = si::radian / si::second;
  return {look, azimuth_rate * per_second, elevation_rate * per_second,
          range_rate * (si::metre / si::second)};
}

Eigen::Vector3d position_of(const Caller& name, const LookAngles& look) {
  const double azimuth = look.azimuth.value(), elevation = look.elevation.value(), range = look.range.value();
  if (!std::isfinite(azimuth)) {
    throw BadInput(name() + "the azimuth " + text(azimuth) + " rad is not finite");
  }
  if (!(std::abs(elevation) <= std::numbers::pi / 2.0)) {
    throw BadInput(name() + "the elevation " + text(elevation) + " rad is not in [-pi/2, pi/2]");
  }
  if (!(range >= 0.0 && std::isfinite(range))) {
    throw BadInput(name() + "the range is " + text(range) + " m");
  }
  const double h = range * std::cos(elevation);
  return {h * std::sin(azimuth), h * std::cos(azimuth), range * std::sin(elevation)};
}

}  // namespace vectrix::detail
