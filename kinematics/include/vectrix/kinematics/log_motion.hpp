#pragma once

#include <cmath>
#include <vectrix/kinematics/hat.hpp>

namespace vectrix::detail {

/// c_n(z) = sum_k (-z)^k / (2 k + n)! of z = |theta|^2 (Stumpff): c_2 = (1 - cos x)/x^2, c_3 = (x - sin
/// x)/x^3, and c_n = 1/n! - z c_(n+2). Their derivatives need no division: 2 dc_n/dz = n c_(n+2) - c_(n+1).
template <class S> struct Stumpff { S c2, c3, c4, c5; };

template <class S> Stumpff<S> stumpff(const S& square) {
  using std::sqrt;
  if (square < S(1)) {  // the first terms left out are below 1e-23
    S c4 = S(1), c5 = S(1);
    for (int k = 22; k > 0; k -= 2) {
      c4 = S(1) - square / S((k + 3) * (k + 4)) * c4;
      c5 = S(1) - square / S((k + 4) * (k + 5)) * c5;
    }
    c4 = c4 / S(24);
    c5 = c5 / S(120);
    return {S(1) / S(2) - square * c4, S(1) / S(6) - square * c5, c4, c5};
  }
  const S angle = sqrt(square);
  const S c2 = (S(1) - cosine<S>(angle)) / square;
  const S c3 = (angle - sine<S>(angle)) / (angle * square);
  return {c2, c3, (S(1) / S(2) - c2) / square, (S(1) / S(6) - c3) / square};
}

/// theta(t) and its derivatives, where q_b^a = q_0 exp(theta) with a constant q_0.
template <class S> struct LogMotion {
  Column<S> theta, rate, acceleration;

  /// w_ab^b = J theta', J = I - c_2 [theta]x + c_3 [theta]x^2 (Bortz's equation, solved for w)
  Column<S> angular_velocity() const {
    const Stumpff<S> c = stumpff<S>(theta.squaredNorm());
    const Column<S> once = theta.cross(rate);
    return rate - c.c2 * once + c.c3 * theta.cross(once);
  }
  /// alpha_ab^b = J theta'' + J' theta'
  Column<S> angular_acceleration() const {
    const Stumpff<S> c = stumpff<S>(theta.squaredNorm());
    const S half_growth = theta.dot(rate);
    const S c2_rate = (S(2) * c.c4 - c.c3) * half_growth;
    const S c3_rate = (S(3) * c.c5 - c.c4) * half_growth;
    const Column<S> once = theta.cross(rate);
    const Column<S> again = theta.cross(acceleration);
    return acceleration - c.c2 * again + c.c3 * theta.cross(again) - c2_rate * once +
           c3_rate * theta.cross(once) + c.c3 * rate.cross(once);
  }
};

/// J of theta, and its inverse I + [theta]x/2 + (c_3 - 2 c_4)/(2 c_2) [theta]x^2 for |theta| < 2 pi.
template <class S> Square<S> log_jacobian(const Column<S>& theta) {
  const Stumpff<S> c = stumpff<S>(theta.squaredNorm());
  const Square<S> once = hat(theta);
  return Square<S>::Identity() - c.c2 * once + c.c3 * once * once;
}
template <class S> Square<S> inverse_log_jacobian(const Column<S>& theta) {
  const Stumpff<S> c = stumpff<S>(theta.squaredNorm());
  const Square<S> once = hat(theta);
  return Square<S>::Identity() + once / S(2) + (c.c3 - S(2) * c.c4) / (S(2) * c.c2) * once * once;
}

}  // namespace vectrix::detail
