#pragma once

#include <cmath>
#include <vectrix/kinematics/quaternion.hpp>
#include <vectrix/kinematics/rotation_vector.hpp>

namespace vectrix {
namespace detail {

template <class B, class A, class S> [[noreturn, gnu::cold, gnu::noinline]] void refuse_exp(S square) {
  throw BadInput("exp(rotation vector of " + frame_name<B>() + " relative to " + frame_name<A>() +
                 "): |theta|^2 is " + text(square));
}

}  // namespace detail

/// The quaternion of a rotation vector, q_b^a = (cos |theta|/2, sin(|theta|/2) theta/|theta|), maps b to a.
/// Accurate to rounding for every angle; below |theta| = 1e-2 a series in |theta|^2 takes over, so that
/// underflow of the square costs nothing. Throws BadInput when theta is not finite or |theta|^2 overflows.
template <class A, class B, class S>
Quaternion<A, B, S> exp_quaternion(const RotationVector<A, B, S>& theta_ab) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const detail::Column<S>& theta = theta_ab.coordinates();
  const S square = theta.squaredNorm();
  S scalar;
  S factor;  // sin(|theta|/2) / |theta|
  if (square < S(1e-4)) {
    // h = |theta|/2: sin(h)/(2h) and cos(h); the first terms left out are below 1e-22.
    const S h2 = square / S(4);
    factor = (S(1) - h2 / S(6) * (S(1) - h2 / S(20) * (S(1) - h2 / S(42)))) / S(2);
    scalar = S(1) - h2 / S(2) * (S(1) - h2 / S(12) * (S(1) - h2 / S(30) * (S(1) - h2 / S(56))));
  } else {
    const S angle = sqrt(square);
    scalar = cos(angle / S(2));
    factor = sin(angle / S(2)) / angle;
    if (!(scalar == scalar)) {  // the cosine of an infinity is no number
      detail::refuse_exp<B, A>(square);
    }
  }
  return {detail::trusted, [&] {
            return Eigen::Quaternion<S>(scalar, factor * theta.x(), factor * theta.y(), factor * theta.z());
          }};
}

/// exp: R_b^a = I + sin|t| [n]x + (1 - cos|t|) ([n]x)^2 for theta_ab = |t| n; turning a by theta_ab gives b.
/// Accuracy and errors as exp_quaternion().
template <class A, class B, class S> Dcm<A, B, S> exp(const RotationVector<A, B, S>& theta_ab) {
  return dcm(exp_quaternion(theta_ab));
}

}  // namespace vectrix
