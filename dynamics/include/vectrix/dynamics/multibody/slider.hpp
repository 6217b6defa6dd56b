#pragma once

#include <vectrix/dynamics/multibody/joint.hpp>

namespace vectrix::multibody {

/// b slides along the unit vector n, which is fixed in b and in its parent, by q at the speed u. The freedom
/// is (0, n), the effort a force along n.
template <class S>
Joint<S> slider(const Square<S>& R_p_from_b, const Column<S>& axis_b, const Column<S>& r_pb_p) {
  Joint<S> j = joint(Kind::slider, R_p_from_b, r_pb_p);
  j.axis_p = R_p_from_b * axis_b;
  return j;
}

struct Slider {
  static constexpr int positions = 1, speeds = 1;

  template <class S, class Parent>
  [[gnu::always_inline]] static void place(const Joint<S>& j, const S* q, const S* u, const Parent& p,
                                           Moving<S>& b) {
    b.R = in_hub(p, j.K0);
    b.axis = in_hub(p, j.axis_p);
    b.r = in_hub(p, j.origin_p) + b.axis * q[0];
    b.w = p.w;
    b.alpha0 = turned_with(p, zero_column<S>());
    b.a0 = carried_by(p, b.r) + cross(p.w, b.axis * S(S(2.0) * u[0]));
  }
  template <class S> static Accelerations<S> relative(const Square<S>&, const S* udot, const Moving<S>& b) {
    return {zero_column<S>(), b.axis * udot[0]};
  }
  template <class S> static S effort(const Transmitted<S>& given, const Moving<S>& b) {
    return dot(b.axis, given.force);
  }
  template <class S> static void rates(const S*, const S* u, S* qdot) { qdot[0] = u[0]; }

  // U = H n, V = M n, D = n.V, e = (effort - n.f0) / D
  template <class S>
  [[gnu::always_inline]] static void eliminate(const Square<S>&, const S* effort, Moving<S>& b) {
    b.U = b.I.H * b.axis;
    b.V = b.I.M * b.axis;
    b.inverse_D = S(1.0) / dot(b.axis, b.V);
    b.e = b.inverse_D * (effort[0] - dot(b.axis, b.I.f));
    eliminate_one(b.I, b.U, b.V, b.inverse_D, b.e);
  }
  template <class S> [[gnu::always_inline]] static void advance(const Square<S>&, Moving<S>& b, S* udot) {
    udot[0] = b.e - b.inverse_D * (dot(b.U, b.alpha) + dot(b.V, b.a));
    b.a += b.axis * udot[0];
  }
  template <class S> static Column<S> velocity(const Square<S>&, const S* u, const Moving<S>& b) {
    return b.axis * u[0];
  }
};

}  // namespace vectrix::multibody
