#pragma once

#include <vectrix/space/orbit/kepler_equation.hpp>
#include <vectrix/space/orbit/two_body.hpp>

namespace vectrix {

namespace detail {

/// The elements of SGP4, or a set of them.
template <class X>
concept MeanOrbit = requires(const X& x) {
  x.bstar;
}
|| requires(const X& x) {
  x.mean_elements();
};

struct KeplerianNumbers {
  double semi_latus_rectum, eccentricity, inclination, ascending_node, argument_of_periapsis, true_anomaly;
};
VECTRIX_EXPORT KeplerianNumbers checked_keplerian(const Caller& name, const KeplerianNumbers& elements);
VECTRIX_EXPORT KeplerianNumbers keplerian_of(const Caller& name, double mu, const OrbitNumbers& orbit);
VECTRIX_EXPORT OrbitNumbers orbit_of_keplerian(const Caller& name, double mu,
                                               const KeplerianNumbers& elements);
/// Columns: to periapsis, a quarter of a turn ahead, normal to the orbit.
VECTRIX_EXPORT Eigen::Matrix3d perifocal_axes(const KeplerianNumbers& elements);

}  // namespace detail

/// The conic of q about p relative to the axes of the inertial frame a, and the place of q on it: semi-latus
/// rectum p, eccentricity e, inclination i in [0, pi], right ascension of the ascending node, argument of
/// periapsis, and true anomaly nu. Every orbit with a plane has them:
///     1.  in the plane of x and y the node is at x: its right ascension is 0; if i = pi, angles go backwards
///     2.  on a circle periapsis is at the node
/// Near those orbits two angles are poorly defined, but their sum (or difference) is accurate, and so is the
/// way back: |r| = p/(1 + e cos nu) to about epsilon (1 + e) |r|/p of it, epsilon = 2.2e-16. That is more
/// than rounding far from the focus of a long, narrow orbit. Made by keplerian_elements().
template <Point P, Point Q, Frame A> class KeplerianElements {
 public:
  explicit KeplerianElements(detail::Trusted, const detail::KeplerianNumbers& numbers) : numbers_(numbers) {}

  Quantity<si::length> semi_latus_rectum() const { return numbers_.semi_latus_rectum * si::metre; }
  double eccentricity() const { return numbers_.eccentricity; }
  Quantity<si::angle> inclination() const { return numbers_.inclination * si::radian; }
  Quantity<si::angle> ascending_node() const { return numbers_.ascending_node * si::radian; }
  Quantity<si::angle> argument_of_periapsis() const { return numbers_.argument_of_periapsis * si::radian; }
  TrueAnomaly true_anomaly() const { return TrueAnomaly(numbers_.true_anomaly * si::radian); }

  /// a = p/(1 - e^2), negative for a hyperbola, infinite for a parabola.
  Quantity<si::length> semi_major_axis() const {
    const double e = numbers_.eccentricity;
    return numbers_.semi_latus_rectum / ((1.0 - e) * (1.0 + e)) * si::metre;
  }
  /// q = p/(1 + e)
  Quantity<si::length> periapsis_distance() const {
    return numbers_.semi_latus_rectum / (1.0 + numbers_.eccentricity) * si::metre;
  }

  /// The bare numbers, in SI units.
  const detail::KeplerianNumbers& numbers() const { return numbers_; }

 private:
  detail::KeplerianNumbers numbers_;
};

/// p = a (1 - e^2), a > 0 for an ellipse, a < 0 for a hyperbola. Throws BadInput if p is not positive and
/// finite: a parabola has no a.
VECTRIX_EXPORT Quantity<si::length> semi_latus_rectum(const Quantity<si::length>& semi_major_axis,
                                                      double eccentricity);

/// Claims the elements of q about p relative to the inertial frame a. Throws BadInput if a number is not
/// finite, p is not positive, e is negative, i is not in [0, pi], or nu is outside the asymptotes.
template <class Q, class P, class A>
detail::IfInertial<A, detail::OfTwo<P, Q, KeplerianElements<P, Q, A>>> keplerian_elements(
    Of<Q>, RelativeTo<P>, In<A>, const Quantity<si::length>& semi_latus_rectum, double eccentricity,
    const Quantity<si::angle>& inclination, const Quantity<si::angle>& ascending_node,
    const Quantity<si::angle>& argument_of_periapsis, const TrueAnomaly& nu) {
  return KeplerianElements<P, Q, A>{
      detail::trusted,
      detail::checked_keplerian(detail::orbit_of<P, Q>("keplerian_elements"),
                                {semi_latus_rectum.value(), eccentricity, inclination.value(),
                                 ascending_node.value(), argument_of_periapsis.value(), nu.angle.value()})};
}

/// The elements of a motion, angles in [-pi, pi], from e cos nu = h^2/(mu r) - 1, e sin nu = h (r . v)/(mu r)
/// and arc tangents of two arguments: to rounding in every case above. Throws BadInput if mu is not positive
/// and finite, r or v is zero, distance_from_singularity() is below nearly_rectilinear, or
/// epsilon (1 + e) |r|/p is above 1e-6: they would not give |r| back.
template <class P, class Q, class A>
detail::IfInertial<A, KeplerianElements<P, Q, A>> keplerian_elements(
    const Quantity<si::gravitational_parameter>& mu, const PointMotion<P, Q, A>& motion) {
  return KeplerianElements<P, Q, A>{
      detail::trusted, detail::keplerian_of(detail::orbit_of<P, Q>("keplerian_elements"), mu.value(),
                                            detail::numbers_of(motion))};
}
template <class... Given>
auto keplerian_elements(  // (mu, motion) or (of<Q>, relative_to<P>, in<A>, p, e, i, node, w, nu): a inertial
    const Given&...) -> Refused = delete;

/// The motion with these elements. Throws BadInput if mu is not positive and finite, or the result is not
/// finite.
template <class P, class Q, class A>
PointMotion<P, Q, A> point_motion(const Quantity<si::gravitational_parameter>& mu,
                                  const KeplerianElements<P, Q, A>& elements) {
  return detail::point_motion_of<P, Q, A>(
      detail::orbit_of_keplerian(detail::orbit_of<P, Q>("point_motion"), mu.value(), elements.numbers()));
}
// Not deleted: clang would list all functions of this name.
template <class Mu, detail::MeanOrbit Elements> Refused point_motion(const Mu&, const Elements&) {
  static_assert(!detail::MeanOrbit<Elements>,
                "osculating elements; mean ones have a motion by their theory alone, Sgp4<Q>");
  return {};
}

}  // namespace vectrix
