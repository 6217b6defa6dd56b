#include <cmath>
#include <numbers>

#include <vectrix/space/sky/right_ascension.hpp>

#include "../earth/turn.hpp"

namespace vectrix::detail {

RightAscensionDeclination right_ascension_of(const Caller& name, const Eigen::Vector3d& r) {
  if (r.isZero(0.0)) throw BadInput(name() + "a zero vector has no direction");
  return {in_one_turn(std::atan2(r.y(), r.x() + 0.0)) * si::radian,
          std::atan2(r.z(), std::hypot(r.x(), r.y())) * si::radian};
}

Eigen::Vector3d direction_of(const Caller& name, const RightAscensionDeclination& place) {
  const double right_ascension = place.right_ascension.value(), declination = place.declination.value();
  if (!std::isfinite(right_ascension)) {
    throw BadInput(name() + "the right ascension " + text(right_ascension) + " rad is not finite");
  }
  if (!(std::abs(declination) <= std::numbers::pi / 2.0)) {
    throw BadInput(name() + "the declination " + text(declination) + " rad is not in [-pi/2, pi/2]");
  }
  return {std::cos(declination) * std::cos(right_ascension),
          std::cos(declination) * std::sin(right_ascension), std::sin(declination)};
}

}  // namespace vectrix::detail
