#include <cmath>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/sky/aberration.hpp>
#include <vectrix/space/sky/star.hpp>

namespace vectrix {
namespace {

constexpr double astronomical_unit = 149597870700.0;  // m, exact
constexpr double arcsecond = std::numbers::pi / 180.0 / 3600.0;

void require_finite(const char* what, double value) {
  if (!std::isfinite(value)) {
    throw BadInput(std::string{what} + detail::text(value) + " is not finite");
  }
}

}  // namespace

ProperMotion::ProperMotion(bool has_cos_declination, const Quantity<si::angular_velocity>& right_ascension,
                           const Quantity<si::angular_velocity>& declination)
    : has_cos_declination_(has_cos_declination),
      right_ascension_(right_ascension),
      declination_(declination) {
  require_finite("ProperMotion: the rate of right ascension, rad/s, ", right_ascension.value());
  require_finite("ProperMotion: the rate of declination, rad/s, ", declination.value());
}

ProperMotion proper_motion_with_cos_declination(const Quantity<si::angular_velocity>& right_ascension,
                                                const Quantity<si::angular_velocity>& declination) {
  return {true, right_ascension, declination};
}

ProperMotion proper_motion_without_cos_declination(const Quantity<si::angular_velocity>& right_ascension,
                                                   const Quantity<si::angular_velocity>& declination) {
  return {false, right_ascension, declination};
}

Star::Star(detail::InIcrs, const RightAscensionDeclination& place, const ProperMotion& motion,
           const Quantity<si::angle>& parallax, const Quantity<si::velocity>& radial_velocity,
           const Epoch& epoch)
    : place_(detail::direction_of({"Star"}, place)),
      parallax_(parallax.value() / astronomical_unit),
      epoch_(epoch) {
  if (!(parallax.value() >= 0.0 && parallax.value() <= arcsecond)) {
    throw BadInput("Star: the parallax " + detail::text(parallax.value()) +
                   " rad is not between 0 and 4.85e-6 rad, 1 arcsec");
  }
  if (!(std::abs(radial_velocity.value()) < speed_of_light.value()))
    throw BadInput("Star: the radial velocity is " + detail::text(radial_velocity.value()) +
                   " m/s; it must be below the speed of light");
  const double alpha = place.right_ascension.value(), delta = place.declination.value();
  const Eigen::Vector3d east(-std::sin(alpha), std::cos(alpha), 0.0);
  const Eigen::Vector3d north(-std::sin(delta) * std::cos(alpha), -std::sin(delta) * std::sin(alpha),
                              std::cos(delta));
  const double factor = motion.has_cos_declination() ? 1.0 : std::cos(delta);
  const Eigen::Vector3d across =
      factor * motion.right_ascension().value() * east + motion.declination().value() * north;
  constexpr double largest_motion = 100.0 * arcsecond / julian_year.value();
  if (!(across.norm() <= largest_motion)) {
    throw BadInput("Star: the proper motion is " + detail::text(across.norm()) +
                   " rad/s; it must be below 1.54e-11 rad/s, 100 arcsec a year");
  }
  rate_ = across + radial_velocity.value() * parallax_ * place_;
}

Vector<earth::Gcrf, si::dimensionless> Star::direction_from_barycentre(const Epoch& epoch) const {
  return {detail::trusted, direction_from(detail::trusted, epoch, Eigen::Vector3d::Zero())};
}

Eigen::Vector3d Star::direction_from(detail::Trusted, const Epoch& epoch, const Eigen::Vector3d& r) const {
  const double elapsed = (epoch - epoch_).value() + r.dot(place_) / speed_of_light.value();
  const Eigen::Vector3d n = place_ + elapsed * rate_ - parallax_ * r;
  const double length = n.norm();
  if (!(length > 0.0 && std::isfinite(length))) {
    throw BadInput("Star: seen from " + detail::text(r.norm()) +
                   " m from the barycentre the star has no direction");
  }
  return n / length;
}

}  // namespace vectrix
