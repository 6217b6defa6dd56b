#pragma once

#include <cmath>
#include <vectrix/frames/scalar/sine_cosine.hpp>
#include <vectrix/frames/scalar/square_root.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/attitude/rotation_vector.hpp>

namespace vectrix {
namespace detail {

/// cos(h) and sin(h)/(2h) of h = |theta|/2, from |theta|^2.
template <class S> struct HalfTurn {
  S scalar;
  S factor;
};
/// Whether the long series is used. It serves double and float up to |theta|^2 = 0.25; its first omitted
/// terms are below 1e-19. Other scalars use the short series up to 1e-4; its first omitted terms are below
/// 1e-22.
template <class S> inline constexpr bool long_series = std::is_same_v<S, double> || std::is_same_v<S, float>;
template <class S> [[gnu::always_inline]] inline HalfTurn<S> half_turn_series(const S& square) {
  const S h2 = square / S(4);
  if constexpr (long_series<S>) {
    const S c = S(1) / S(40320) - h2 * (S(1) / S(3628800) - h2 * (S(1) / S(479001600)));
    const S s = S(1) / S(725760) - h2 * (S(1) / S(79833600) - h2 * (S(1) / S(12454041600)));
    return {S(1) - h2 * (S(1) / S(2) - h2 * (S(1) / S(24) - h2 * (S(1) / S(720) - h2 * c))),
            S(1) / S(2) - h2 * (S(1) / S(12) - h2 * (S(1) / S(240) - h2 * (S(1) / S(10080) - h2 * s)))};
  } else {
    return {S(1) - h2 * (S(1) / S(2) - h2 * (S(1) / S(24) - h2 * (S(1) / S(720) - h2 * (S(1) / S(40320))))),
            S(1) / S(2) - h2 * (S(1) / S(12) - h2 * (S(1) / S(240) - h2 * (S(1) / S(10080))))};
  }
}
template <class S> [[gnu::always_inline]] inline HalfTurn<S> half_turn_by_sine(const S& square) {
  const S angle = square_root(square);
  const auto [sine, cosine] = sine_cosine<S>(angle / S(2));
  return {cosine, sine / angle};
}
/// Accurate to rounding for every angle. NaN if |theta|^2 is infinite or NaN.
template <class S> [[gnu::always_inline]] inline HalfTurn<S> half_turn(const S& square) {
  const auto small = square < number<S>(long_series<S> ? 0.25 : 1e-4);
  if constexpr (Batch<S>) {
    HalfTurn<S> half = half_turn_series(square);
    if (!all(small)) {
      const HalfTurn<S> other = half_turn_by_sine(square);
      half = {select(small, half.scalar, other.scalar), select(small, half.factor, other.factor)};
    }
    return half;
  } else {
    return small ? half_turn_series(square) : half_turn_by_sine(square);
  }
}

template <class B, class A, class S> [[noreturn, gnu::cold, gnu::noinline]] void refuse_exp(S square) {
  throw BadInput("exp(rotation vector of " + frame_name<B>() + " relative to " + frame_name<A>() +
                 "): |theta|^2 is " + text(square));
}

}  // namespace detail

/// The quaternion of a rotation vector, q_b^a = (cos |theta|/2, sin(|theta|/2) theta/|theta|), maps b to a.
/// Accurate to rounding for every angle; small angles use a series in |theta|^2, so that underflow of the
/// square does no harm. Throws BadInput when theta is not finite or |theta|^2 overflows.
template <class A, class B, class S>
[[gnu::always_inline]] inline Quaternion<A, B, S> exp_quaternion(const RotationVector<A, B, S>& theta_ab) {
  const detail::Column<S>& theta = theta_ab.coordinates();
  const S square = theta.squaredNorm();
  const detail::HalfTurn<S> half = detail::half_turn(square);
  if (!detail::all(half.scalar == half.scalar)) detail::refuse_exp<B, A>(square);
  return {detail::trusted, [&] {
            return Eigen::Quaternion<S>(half.scalar, half.factor * theta.x(), half.factor * theta.y(),
                                        half.factor * theta.z());
          }};
}

/// exp: R_b^a = I + sin|t| [n]x + (1 - cos|t|) ([n]x)^2 for theta_ab = |t| n; turning a by theta_ab gives b.
/// Accuracy and errors as exp_quaternion().
template <class A, class B, class S> Dcm<A, B, S> exp(const RotationVector<A, B, S>& theta_ab) {
  return dcm(exp_quaternion(theta_ab));
}
template <class Given>
  requires detail::is_framed<Given>
auto exp(const Given&) -> Refused = delete;  // exp(theta_ab), exp(xi_ab): of a rotation vector or a screw

}  // namespace vectrix
