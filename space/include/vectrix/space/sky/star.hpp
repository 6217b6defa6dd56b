#pragma once

#include <Eigen/Core>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/sky/right_ascension.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {
namespace detail {

/// in<earth::Gcrf>, and a short message for another frame, also if the next arguments are in braces.
struct InIcrs {
  constexpr InIcrs(In<earth::Gcrf>) {}
  template <class F>
  InIcrs(  // in<earth::Gcrf>, whose axes are those of the ICRS
      In<F>) = delete;
};

}  // namespace detail

/// The year of proper motions, 365.25 days.
inline constexpr Quantity<si::time> julian_year = 31557600.0 * si::second;

/// How a star moves across the sky. Whether the rate of right ascension has the factor cos(declination) has
/// to be said:
///     proper_motion_with_cos_declination       Hipparcos, Tycho, Gaia
///     proper_motion_without_cos_declination    FK5, ERFA
/// Both throw BadInput if a rate is not finite.
class ProperMotion {
 public:
  template <class Any>
  ProperMotion(  // proper_motion_with_cos_declination or proper_motion_without_cos_declination
      const Quantity<si::angular_velocity>&, const Any&) = delete;
  template <class Any>
  ProperMotion(  // proper_motion_with_cos_declination or proper_motion_without_cos_declination
      const Any&) = delete;

  [[nodiscard]] const Quantity<si::angular_velocity>& right_ascension() const { return right_ascension_; }
  [[nodiscard]] const Quantity<si::angular_velocity>& declination() const { return declination_; }
  [[nodiscard]] bool has_cos_declination() const { return has_cos_declination_; }

  friend VECTRIX_EXPORT ProperMotion
  proper_motion_with_cos_declination(const Quantity<si::angular_velocity>& right_ascension,
                                     const Quantity<si::angular_velocity>& declination);
  friend VECTRIX_EXPORT ProperMotion
  proper_motion_without_cos_declination(const Quantity<si::angular_velocity>& right_ascension,
                                        const Quantity<si::angular_velocity>& declination);

 private:
  ProperMotion(bool has_cos_declination, const Quantity<si::angular_velocity>& right_ascension,
               const Quantity<si::angular_velocity>& declination);

  bool has_cos_declination_;
  Quantity<si::angular_velocity> right_ascension_, declination_;
};

VECTRIX_EXPORT ProperMotion proper_motion_with_cos_declination(
    const Quantity<si::angular_velocity>& right_ascension, const Quantity<si::angular_velocity>& declination);
VECTRIX_EXPORT ProperMotion proper_motion_without_cos_declination(
    const Quantity<si::angular_velocity>& right_ascension, const Quantity<si::angular_velocity>& declination);

/// A star of a catalogue: its place at an epoch along the axes of earth::Gcrf, which are those of the ICRS,
/// and how it moves. It moves along a straight line, in units of its distance at the catalogue's epoch t0:
///     n(t) = direction of  n0 + (t - t0) (m + n0 v_r p/au)
/// n0 the place, m the proper motion across it, v_r the radial velocity, away from us, p the parallax.
/// Throws BadInput if a number is not finite, |declination| exceeds pi/2, |m| exceeds 100 arcsec a year, ten
/// times the fastest, or the parallax is negative or above 1 arcsec: no star is nearer. Some catalogues have
/// negative parallaxes for distant stars: 0 stands for them.
class VECTRIX_EXPORT Star {
 public:
  Star(detail::InIcrs, const RightAscensionDeclination& place, const ProperMotion& motion,
       const Quantity<si::angle>& parallax, const Quantity<si::velocity>& radial_velocity,
       const Epoch& epoch);

  /// n(t), as seen from the barycentre of the solar system.
  [[nodiscard]] Vector<earth::Gcrf, si::dimensionless> direction_from_barycentre(const Epoch& epoch) const;

  /// The direction from an observer at r relative to the barycentre, m. The light comes from the star by
  /// r.n0/c earlier than at the barycentre. Throws BadInput if r is not finite.
  [[nodiscard]] Eigen::Vector3d direction_from(detail::Trusted, const Epoch& epoch,
                                               const Eigen::Vector3d& r) const;

 private:
  Eigen::Vector3d place_, rate_;  // rate_ 1/s
  double parallax_;               // 1/m: 1/distance
  Epoch epoch_;
};

}  // namespace vectrix
