#pragma once

#include <vectrix/frames/covariance.hpp>
#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/kinematics/estimation/observation.hpp>

namespace vectrix {

/// Smallest sine of the angle between two directions that triad() accepts. Below it rounding decides the turn
/// about them.
inline constexpr double nearly_parallel = 1e-9;

/// The result of triad() for two observations.
template <Frame B, Frame A, class S = double> struct TriadEstimate {
  Dcm<B, A, S> rotation;
  /// Of the small turn from the true to the estimated attitude.
  Covariance<B, si::angle, S> covariance;
  /// The angle between the two directions in b minus that in a; its variance is sigma_1^2 + sigma_2^2.
  Quantity<si::angle, S> mismatch;
};

namespace detail {

/// The axes r, t, n of two directions, in columns: t is normal to r in their plane, on the side of s.
template <class F, class B, class A, class S>
Square<S> triad_axes(const Vector<F, si::dimensionless, S>& r, const Vector<F, si::dimensionless, S>& s) {
  const Column<S>& first = r.coordinates();
  const Column<S> across = s.coordinates() - first * first.dot(s.coordinates());
  const S sine = across.norm();
  if (!all(sine > number<S>(door_tolerance<S>(nearly_parallel)))) {
    throw BadInput(dcm_door<B, A>("triad") + "the sine of the angle between the two directions in " +
                   frame_name<F>() + " is " + text(sine) + "; parallel directions fix no rotation");
  }
  Column<S> t = across / sine;
  t -= first * first.dot(t);  // again, because the first difference may have lost digits
  t /= t.norm();
  Square<S> axes;
  axes << first, t, first.cross(t);
  return axes;
}

template <class B, class A, class S>
Dcm<B, A, S> triad_of(const Vector<B, si::dimensionless, S>& r_b, const Vector<A, si::dimensionless, S>& r_a,
                      const Vector<B, si::dimensionless, S>& s_b,
                      const Vector<A, si::dimensionless, S>& s_a) {
  return {trusted, triad_axes<B, B, A>(r_b, s_b) * triad_axes<A, B, A>(r_a, s_a).transpose()};
}

}  // namespace detail

/// R_a^b from two vectors given in both frames: r_b = R_a^b r_a in direction, and s_b in the half plane of
/// R_a^b s_a (Black 1964). r is matched exactly; s only fixes the turn about r. Works for any scalar.
/// Throws BadInput for a zero vector, and when the two are parallel to nearly_parallel in either frame.
template <Frame B, Frame A, class U, class V, class S>
detail::OfTwo<B, A, Dcm<B, A, S>> triad(To<B>, From<A>, const Vector<B, U, S>& r_b,
                                        const Vector<A, U, S>& r_a, const Vector<B, V, S>& s_b,
                                        const Vector<A, V, S>& s_a) {
  const auto along = [](const auto& r) { return detail::direction_for("triad", r); };
  return detail::triad_of(along(r_b), along(r_a), along(s_b), along(s_a));
}

/// The same from two observations, the more accurate one first, with the covariance of the result:
///     P = s1^2 I + ((s2^2 - s1^2) b1 b1^T + s1^2 (b1 . b2) (b1 b2^T + b2 b1^T)) / |b1 x b2|^2
/// for standard deviations s1, s2, to first order in the errors.
/// Shuster and Oh, Three-Axis Attitude Determination from Vector Observations (1981).
template <Frame B, Frame A, class S>
detail::OfTwo<B, A, TriadEstimate<B, A, S>> triad(To<B>, From<A>, const Observation<B, A, S>& first,
                                                  const Observation<B, A, S>& second) {
  const Dcm<B, A, S> R =
      detail::triad_of(first.measured(), first.reference(), second.measured(), second.reference());
  const detail::Column<S>& b1 = first.measured().coordinates();
  const detail::Column<S>& b2 = second.measured().coordinates();
  const detail::Column<S>& a1 = first.reference().coordinates();
  const detail::Column<S>& a2 = second.reference().coordinates();
  const S cosine = b1.dot(b2), sine = b1.cross(b2).norm();
  const S sigma1 = first.deviation().value(), sigma2 = second.deviation().value();
  const detail::Column<S> t = (b2 - cosine * b1) / sine;
  // The same P with b2 = (b1 . b2) b1 + |b1 x b2| t, as a sum of squares; both observations contribute to the
  // turn about b1.
  const detail::Column<S> both = t + (cosine / sine) * b1;
  const detail::Column<S> n = b1.cross(t), alone = (sigma2 / sine) * b1;
  const detail::Square<S> P =
      sigma1 * sigma1 * (both * both.transpose() + n * n.transpose()) + alone * alone.transpose();
  const S mismatch =
      detail::arc_tangent(sine, cosine) - detail::arc_tangent<S>(a1.cross(a2).norm(), a1.dot(a2));
  return {R, Covariance<B, si::angle, S>{detail::trusted, P}, Quantity<si::angle, S>::from_value(mismatch)};
}
template <class ToFrame, class FromFrame, class First, class Second, class... Others>
auto triad(  // to<B>, from<A>, r_b, r_a, s_b, s_a, or two observations of b and a
    const ToFrame&, const FromFrame&, const First&, const Second&, const Others&...) -> Refused = delete;

}  // namespace vectrix
