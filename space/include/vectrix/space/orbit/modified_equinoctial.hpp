#pragma once

#include <cmath>
#include <concepts>
#include <vectrix/space/orbit/two_body.hpp>

namespace vectrix {

/// The retrograde factor I of equinoctial elements: prograde elements are singular at i = pi, retrograde ones
/// at i = 0. The same orbit has different elements, so the factor is part of the type.
struct Prograde {
  static constexpr int factor = 1;
};
struct Retrograde {
  static constexpr int factor = -1;
};
inline constexpr Prograde prograde{};
inline constexpr Retrograde retrograde{};

template <class Sense>
concept OrbitSense = std::same_as<Sense, Prograde> || std::same_as<Sense, Retrograde>;

namespace detail {

struct EquinoctialNumbers {
  double p, f, g, h, k, L;
};
VECTRIX_EXPORT EquinoctialNumbers checked_equinoctial(const Caller& name, const EquinoctialNumbers& elements);
VECTRIX_EXPORT EquinoctialNumbers equinoctial_of(const Caller& name, int factor, double mu,
                                                 const OrbitNumbers& orbit);
VECTRIX_EXPORT OrbitNumbers orbit_of_equinoctial(const Caller& name, int factor, double mu,
                                                 const EquinoctialNumbers& elements);

}  // namespace detail

/// Modified equinoctial elements of q about p relative to the axes of the inertial frame a (Walker, Ireland
/// and Owens, A set of modified equinoctial orbit elements, 1985), with I = 1 prograde, -1 retrograde, Om the
/// right ascension of the node and w the argument of periapsis:
///     p semi-latus rectum             f = e cos(w + I Om), g = e sin(w + I Om)
///     L = nu + w + I Om               h = tan^I(i/2) cos Om, k = tan^I(i/2) sin Om
/// They have no other singularity: circles, the plane of x and y, parabolas and hyperbolas are regular.
template <Point P, Point Q, Frame A, OrbitSense Sense> class ModifiedEquinoctial {
 public:
  explicit ModifiedEquinoctial(detail::Trusted, const detail::EquinoctialNumbers& numbers)
      : numbers_(numbers) {}

  Quantity<si::length> semi_latus_rectum() const { return numbers_.p * si::metre; }
  double f() const { return numbers_.f; }
  double g() const { return numbers_.g; }
  double h() const { return numbers_.h; }
  double k() const { return numbers_.k; }
  Quantity<si::angle> true_longitude() const { return numbers_.L * si::radian; }

  /// The angle between the plane of the orbit and that of x and y, run through backwards (prograde) or
  /// forwards (retrograde).
  Quantity<si::angle> distance_from_singularity() const {
    return 2.0 * std::atan2(1.0, std::hypot(numbers_.h, numbers_.k)) * si::radian;
  }

  /// The bare numbers, in SI units.
  const detail::EquinoctialNumbers& numbers() const { return numbers_; }

 private:
  detail::EquinoctialNumbers numbers_;
};

/// Claims the elements of q about p relative to the inertial frame a. Throws BadInput if a number is not
/// finite, p is not positive, or 1 + f cos L + g sin L is not: outside the asymptotes.
template <OrbitSense Sense, class Q, class P, class A>
detail::IfInertial<A, detail::OfTwo<P, Q, ModifiedEquinoctial<P, Q, A, Sense>>> modified_equinoctial(
    Sense, Of<Q>, RelativeTo<P>, In<A>, const Quantity<si::length>& semi_latus_rectum, double f, double g,
    double h, double k, const Quantity<si::angle>& true_longitude) {
  return ModifiedEquinoctial<P, Q, A, Sense>{
      detail::trusted,
      detail::checked_equinoctial(detail::orbit_of<P, Q>("modified_equinoctial"),
                                  {semi_latus_rectum.value(), f, g, h, k, true_longitude.value()})};
}

/// The elements of a motion, L in [-pi, pi]. Throws BadInput if mu is not positive and finite, at the
/// singularity, and where keplerian_elements() does. The way back has the same error.
template <OrbitSense Sense, class P, class Q, class A>
detail::IfInertial<A, ModifiedEquinoctial<P, Q, A, Sense>> modified_equinoctial(
    Sense, const Quantity<si::gravitational_parameter>& mu, const PointMotion<P, Q, A>& motion) {
  return ModifiedEquinoctial<P, Q, A, Sense>{
      detail::trusted, detail::equinoctial_of(detail::orbit_of<P, Q>("modified_equinoctial"), Sense::factor,
                                              mu.value(), detail::numbers_of(motion))};
}
template <class Sense, class... Given>
auto modified_equinoctial(  // sense, (mu, motion) or (of<Q>, relative_to<P>, in<A>, six numbers): a inertial
    Sense, const Given&...) -> Refused = delete;

/// The motion with these elements. Throws BadInput if mu is not positive and finite, or the result is not
/// finite.
template <class P, class Q, class A, class Sense>
PointMotion<P, Q, A> point_motion(const Quantity<si::gravitational_parameter>& mu,
                                  const ModifiedEquinoctial<P, Q, A, Sense>& elements) {
  return detail::point_motion_of<P, Q, A>(detail::orbit_of_equinoctial(
      detail::orbit_of<P, Q>("point_motion"), Sense::factor, mu.value(), elements.numbers()));
}

}  // namespace vectrix
