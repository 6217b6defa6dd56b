#pragma once

#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/kinematics/attitude/along_axis.hpp>

namespace vectrix {

/// sigma_ab, of type ModifiedRodrigues<A, B>, the modified Rodrigues parameters: sigma = n tan(phi/4), where
/// turning a by phi about n gives b.
///     q_b^a = (1 - |sigma|^2, 2 sigma) / (1 + |sigma|^2)
/// sigma and its shadow -sigma / |sigma|^2 are the same rotation; for |sigma| < 1 the shadow is the longer
/// turn. Singular at a full turn, where sigma is infinite: within eight roundings of it every door throws
/// BadInput with the distance. switch_to_shadow() avoids it.
template <Frame A, Frame B, class S = double>
class ModifiedRodrigues : public detail::AlongAxis<ModifiedRodrigues<A, B, S>, A, B, S> {
 public:
  using detail::AlongAxis<ModifiedRodrigues<A, B, S>, A, B, S>::AlongAxis;

  /// The distance of the turn from a full turn, 2 pi - phi.
  Quantity<si::angle, S> distance_from_singularity() const {
    return Quantity<si::angle, S>::from_value(
        S(4) * detail::arc_tangent<S>(S(1), detail::scaled_norm(this->coordinates())));
  }
  /// The other parameters of the same rotation, -sigma / |sigma|^2. Throws BadInput near sigma = 0, whose
  /// shadow is at the singularity.
  ModifiedRodrigues shadow() const {
    const S norm = detail::scaled_norm(this->coordinates());
    detail::require_regular<ModifiedRodrigues>(S(4) * norm, "shadow");
    return {detail::trusted, -(this->coordinates() / norm) / norm};
  }
  /// sigma_ba = -sigma_ab
  ModifiedRodrigues<B, A, S> operator-() const { return {detail::trusted, -this->coordinates()}; }

  /// The scalar part is negative when |sigma| > 1.
  friend Quaternion<A, B, S> quaternion(const ModifiedRodrigues& sigma_ab) {
    const detail::Column<S>& sigma = sigma_ab.coordinates();
    const S square = sigma.squaredNorm();
    const S scale = S(1) / (S(1) + square);
    const S twice = S(2) * scale;
    return {detail::trusted, [&] {
              return Eigen::Quaternion<S>((S(1) - square) * scale, twice * sigma.x(), twice * sigma.y(),
                                          twice * sigma.z());
            }};
  }
  friend Dcm<A, B, S> dcm(const ModifiedRodrigues& sigma_ab) { return dcm(quaternion(sigma_ab)); }

  static const char* name() { return "modified Rodrigues parameters"; }
  static const char* singularity() { return "a full turn"; }
};

template <class A, class B, class S>
inline constexpr bool detail::is_framed<ModifiedRodrigues<A, B, S>> = true;

/// Claims that the vector, expressed in a or in b, is n tan(phi/4) of the turn from a to b. Any length is
/// valid. Throws BadInput when it is not finite, or at the singularity.
template <Frame B, Frame A, class C, class S>
detail::OfTwo<B, A, detail::InOneOf<C, A, B, ModifiedRodrigues<A, B, S>>> modified_rodrigues(
    Of<B>, RelativeTo<A>, const Vector<C, si::dimensionless, S>& sigma) {
  const ModifiedRodrigues<A, B, S> x{detail::trusted, sigma.coordinates()};
  detail::require_away(x, 4, "modified_rodrigues");
  return x;
}
template <class OfFrame, class RelativeToFrame, class Given>
auto modified_rodrigues(  // of<B>, relative_to<A>: two frames; numbers without unit, expressed in one of them
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

template <class A, class B, class S> struct SwitchedRodrigues {
  ModifiedRodrigues<A, B, S> parameters;
  /// Whether these are the shadow of the given parameters; for a batch, a mask of the lanes.
  decltype(std::declval<const S&>() > std::declval<const S&>()) switched;
};

/// The parameters of the shorter turn, |sigma| <= 1, and whether they are the shadow of the given ones: this
/// is so when |sigma| > 1. No other function switches. The derivative of sigma jumps together with sigma.
/// Compute it again from the rate, which does not jump, or by shadow_rate().
template <class A, class B, class S>
[[nodiscard]] SwitchedRodrigues<A, B, S> switch_to_shadow(const ModifiedRodrigues<A, B, S>& sigma_ab) {
  const detail::Column<S>& sigma = sigma_ab.coordinates();
  const auto switched = sigma.squaredNorm() > S(1);
  const S norm = detail::select<S>(switched, detail::scaled_norm(sigma), S(1));
  const auto chosen = [&](Eigen::Index i) {
    return detail::select<S>(switched, S(-(sigma(i) / norm) / norm), sigma(i));
  };
  return {{detail::trusted, detail::Column<S>(chosen(0), chosen(1), chosen(2))}, switched};
}
/// The derivative of sigma.shadow(): (2 sigma (sigma . sigma')/|sigma|^2 - sigma') / |sigma|^2.
template <class A, class B, class S>
ParameterRate<ModifiedRodrigues<A, B, S>> shadow_rate(
    const ModifiedRodrigues<A, B, S>& sigma_ab,
    const ParameterRate<ModifiedRodrigues<A, B, S>>& sigmadot_ab) {
  const detail::Column<S> shadow = sigma_ab.shadow().coordinates();
  const detail::Column<S>& rate = sigmadot_ab.coordinates();
  return {detail::trusted, S(2) * shadow * shadow.dot(rate) - shadow.squaredNorm() * rate};
}

namespace detail {

template <class A, class B, class S>
ModifiedRodrigues<A, B, S> modified_rodrigues_of(const Quaternion<A, B, S>& q_a_from_b) {
  const Eigen::Quaternion<S> q = shorter_way(q_a_from_b.eigen());
  return {trusted, q.vec() / (S(1) + q.w())};
}

}  // namespace detail

/// sigma = v / (1 + q_w) of a quaternion q_b^a = (q_w, v) or (-q_w, -v), or of R_b^a: the shorter turn,
/// |sigma| <= 1. At half a turn, where sigma and its shadow have length 1, the first non-zero component is
/// positive. Any rotation is valid.
template <class Rotation>
auto modified_rodrigues(const Rotation& R_a_from_b)
    -> decltype(detail::modified_rodrigues_of(detail::as_quaternion(R_a_from_b))) {
  return detail::modified_rodrigues_of(detail::as_quaternion(R_a_from_b));
}

namespace detail {

/// With the upper sign for a rate expressed in b, the lower for one in a (Schaub and Junkins 1996):
///     sigma' = 1/4 ((1 - s) w +- 2 sigma x w + 2 sigma (sigma . w)),  s = |sigma|^2
///     w = 4 ((1 - s) sigma' -+ 2 sigma x sigma' + 2 sigma (sigma . sigma')) / (1 + s)^2
/// and their derivatives.
template <class A, class B, class S, bool expressed_in_turned>
struct KinematicsOf<ModifiedRodrigues<A, B, S>, expressed_in_turned> {
  using Parameters = ModifiedRodrigues<A, B, S>;

  static Column<S> rate(const Parameters& x, const Column<S>& w) {
    const Column<S>& sigma = x.coordinates();
    return ((S(1) - sigma.squaredNorm()) * w + S(2) * turn(sigma, w) + S(2) * sigma * sigma.dot(w)) / S(4);
  }
  static Column<S> velocity(const Parameters& x, const Column<S>& rate) {
    const Column<S>& sigma = x.coordinates();
    const S square = sigma.squaredNorm();
    const Column<S> sum = (S(1) - square) * rate - S(2) * turn(sigma, rate) + S(2) * sigma * sigma.dot(rate);
    return sum * (S(4) / ((S(1) + square) * (S(1) + square)));
  }
  static Column<S> second_rate(const Parameters& x, const Column<S>& sigmadot, const Column<S>& w,
                               const Column<S>& alpha) {
    return rate(x, alpha) + drift(x, sigmadot, w);
  }
  // sigma'' is linear in alpha; the part without alpha is subtracted.
  static Column<S> acceleration(const Parameters& x, const Column<S>& sigmadot, const Column<S>& sigmaddot) {
    return velocity(x, sigmaddot - drift(x, sigmadot, velocity(x, sigmadot)));
  }

 private:
  static Column<S> turn(const Column<S>& sigma, const Column<S>& w) {
    return turn_of<expressed_in_turned, S>(sigma, w);
  }
  static Column<S> drift(const Parameters& x, const Column<S>& sigmadot, const Column<S>& w) {
    const Column<S>& sigma = x.coordinates();
    return (turn(sigmadot, w) - sigma.dot(sigmadot) * w + sigmadot * sigma.dot(w) + sigma * sigmadot.dot(w)) /
           S(2);
  }
};

}  // namespace detail
}  // namespace vectrix
