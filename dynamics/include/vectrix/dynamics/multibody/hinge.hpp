#pragma once

#include <vectrix/dynamics/multibody/joint.hpp>
#include <vectrix/frames/scalar/sine_cosine.hpp>

namespace vectrix::multibody {

/// b turns about the unit vector n, which is fixed in b and in its parent, by the angle q at the speed u:
///     R_b^p = R_0 exp(q [n]x) = K0 + cos q K1 + sin q K2,   K0 = R_0 n n^T, K1 = R_0 - K0, K2 = R_0 [n]x
/// so that any axis costs what a coordinate axis costs. The freedom is (n, 0), the effort a torque about n.
template <class S>
Joint<S> hinge(const Square<S>& R_p_from_b, const Column<S>& axis_b, const Column<S>& r_pb_p) {
  const Column<S>& n = axis_b;
  const Column<S> along = R_p_from_b * n;
  const Square<S> K0{along * n.x, along * n.y, along * n.z};
  const Square<S> K1{R_p_from_b.x - K0.x, R_p_from_b.y - K0.y, R_p_from_b.z - K0.z};
  return {Kind::hinge, K0, K1, R_p_from_b * hat(n), along, r_pb_p};
}

struct Hinge {
  static constexpr int positions = 1, speeds = 1;

  template <class S, class Parent>
  [[gnu::always_inline]] static void place(const Joint<S>& j, const S* q, const S* u, const Parent& p,
                                           Moving<S>& b) {
    const auto [s, c] = detail::sine_cosine(q[0]);
    const auto turned = [&s = s, &c = c](const Column<S>& k0, const Column<S>& k1, const Column<S>& k2) {
      return k0 + k1 * c + k2 * s;
    };
    b.R = in_hub(p, Square<S>{turned(j.K0.x, j.K1.x, j.K2.x), turned(j.K0.y, j.K1.y, j.K2.y),
                              turned(j.K0.z, j.K1.z, j.K2.z)});
    b.r = in_hub(p, j.origin_p);
    b.axis = in_hub(p, j.axis_p);
    const Column<S> w_pb = b.axis * u[0];
    b.w = p.w + w_pb;
    b.alpha0 = turned_with(p, w_pb);
    b.a0 = carried_by(p, b.r);
  }
  template <class S> static Accelerations<S> relative(const Square<S>&, const S* udot, const Moving<S>& b) {
    return {b.axis * udot[0], zero_column<S>()};
  }
  template <class S> static S effort(const Transmitted<S>& given, const Moving<S>& b) {
    return dot(b.axis, given.torque);
  }
  template <class S> static void rates(const S*, const S* u, S* qdot) { qdot[0] = u[0]; }

  // U = A n, V = H^T n, D = n.U, e = (effort - n.n0) / D
  template <class S>
  [[gnu::always_inline]] static void eliminate(const Square<S>&, const S* effort, Moving<S>& b) {
    b.U = b.I.A * b.axis;
    b.V = transposed_times(b.I.H, b.axis);
    b.inverse_D = S(1.0) / dot(b.axis, b.U);
    b.e = b.inverse_D * (effort[0] - dot(b.axis, b.I.n));
    eliminate_one(b.I, b.U, b.V, b.inverse_D, b.e);
  }
  // u' = e - (U.alpha + V.a) / D, with the parent's accelerations at the joint
  template <class S> [[gnu::always_inline]] static void advance(const Square<S>&, Moving<S>& b, S* udot) {
    udot[0] = b.e - b.inverse_D * (dot(b.U, b.alpha) + dot(b.V, b.a));
    b.alpha += b.axis * udot[0];
  }
  /// v_pb|p, the velocity of b's origin that the parent observes.
  template <class S> static Column<S> velocity(const Square<S>&, const S*, const Moving<S>&) {
    return zero_column<S>();
  }
};

}  // namespace vectrix::multibody
