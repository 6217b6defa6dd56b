#pragma once

#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/kinematics/attitude/along_axis.hpp>

namespace vectrix {

/// g_ab, of type GibbsVector<A, B>, the classical Rodrigues parameters: g = n tan(phi/2), where turning a by
/// phi about n gives b.
///     q_b^a = (1, g) / sqrt(1 + |g|^2)
/// Each rotation has one Gibbs vector, except a half turn, where g is infinite. Within eight roundings of it
/// every door throws BadInput with the distance.
template <Frame A, Frame B, class S = double>
class GibbsVector : public detail::AlongAxis<GibbsVector<A, B, S>, A, B, S> {
 public:
  using detail::AlongAxis<GibbsVector<A, B, S>, A, B, S>::AlongAxis;

  /// The distance of the turn from half a turn, pi - phi.
  Quantity<si::angle, S> distance_from_singularity() const {
    return Quantity<si::angle, S>::from_value(
        S(2) * detail::arc_tangent<S>(S(1), detail::scaled_norm(this->coordinates())));
  }
  /// g_ba = -g_ab
  GibbsVector<B, A, S> operator-() const { return {detail::trusted, -this->coordinates()}; }

  friend Quaternion<A, B, S> quaternion(const GibbsVector& g_ab) {
    using std::sqrt;
    const detail::Column<S>& g = g_ab.coordinates();
    const S length = sqrt(S(S(1) + g.squaredNorm()));
    return {detail::trusted, [&] {
              return Eigen::Quaternion<S>(S(1) / length, g.x() / length, g.y() / length, g.z() / length);
            }};
  }
  friend Dcm<A, B, S> dcm(const GibbsVector& g_ab) { return dcm(quaternion(g_ab)); }

  static const char* name() { return "Gibbs vector"; }
  static const char* singularity() { return "half a turn"; }
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<GibbsVector<A, B, S>> = true;

/// Claims that the vector, expressed in a or in b, is n tan(phi/2) of the turn from a to b. Throws BadInput
/// when it is not finite, or at the singularity.
template <Frame B, Frame A, class C, class S>
detail::OfTwo<B, A, detail::InOneOf<C, A, B, GibbsVector<A, B, S>>> gibbs_vector(
    Of<B>, RelativeTo<A>, const Vector<C, si::dimensionless, S>& g) {
  const GibbsVector<A, B, S> x{detail::trusted, g.coordinates()};
  detail::require_away(x, 2, "gibbs_vector");
  return x;
}
template <class OfFrame, class RelativeToFrame, class Given>
auto gibbs_vector(  // of<B>, relative_to<A>: two frames; numbers without unit, expressed in one of them
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

namespace detail {

template <class A, class B, class S> GibbsVector<A, B, S> gibbs_of(const Quaternion<A, B, S>& q_a_from_b) {
  const auto& q = q_a_from_b.eigen();
  require_regular<GibbsVector<A, B, S>>(S(2) * q.w(), "gibbs_vector");
  return {trusted, q.vec() / q.w()};
}

}  // namespace detail

/// g = v / q_w of a quaternion q_b^a = (q_w, v) or of R_b^a; the sign of q does not matter. Throws BadInput
/// with the distance within eight roundings of half a turn.
template <class Rotation>
auto gibbs_vector(const Rotation& R_a_from_b)
    -> decltype(detail::gibbs_of(detail::as_quaternion(R_a_from_b))) {
  return detail::gibbs_of(detail::as_quaternion(R_a_from_b));
}

namespace detail {

/// With the upper sign for a rate expressed in b, the lower for one in a:
///     g' = 1/2 (w +- g x w + g (g . w))        w = 2 (g' -+ g x g') / (1 + |g|^2)
/// and their derivatives.
template <class A, class B, class S, bool expressed_in_turned>
struct KinematicsOf<GibbsVector<A, B, S>, expressed_in_turned> {
  using Parameters = GibbsVector<A, B, S>;

  static Column<S> rate(const Parameters& x, const Column<S>& w) {
    const Column<S>& g = x.coordinates();
    return (w + turn(g, w) + g * g.dot(w)) / S(2);
  }
  static Column<S> velocity(const Parameters& x, const Column<S>& gdot) {
    const Column<S>& g = x.coordinates();
    return (gdot - turn(g, gdot)) * (S(2) / (S(1) + g.squaredNorm()));
  }
  static Column<S> second_rate(const Parameters& x, const Column<S>& gdot, const Column<S>& w,
                               const Column<S>& alpha) {
    return rate(x, alpha) + drift(x, gdot, w);
  }
  // g'' is linear in alpha; the part without alpha is subtracted.
  static Column<S> acceleration(const Parameters& x, const Column<S>& gdot, const Column<S>& gddot) {
    return velocity(x, gddot - drift(x, gdot, velocity(x, gdot)));
  }

 private:
  static Column<S> turn(const Column<S>& g, const Column<S>& w) {
    return turn_of<expressed_in_turned, S>(g, w);
  }
  static Column<S> drift(const Parameters& x, const Column<S>& gdot, const Column<S>& w) {
    const Column<S>& g = x.coordinates();
    return (turn(gdot, w) + gdot * g.dot(w) + g * gdot.dot(w)) / S(2);
  }
};

}  // namespace detail
}  // namespace vectrix
