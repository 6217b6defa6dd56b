#pragma once

#include <vectrix/dynamics/multibody/joint.hpp>

namespace vectrix::multibody {

/// b moves freely, and its motion is counted from the parent. The positions are the quaternion of R_0^-1
/// R_b^p, scalar first, and the way of b's origin from its place at zero, in the parent's axes; the speeds
/// are w_pb^b and that way's derivative; the efforts are a torque in the axes of b and a force in the
/// parent's. The parent feels nothing of b but the efforts.
struct Free {
  static constexpr int positions = 7, speeds = 6;

  template <class S, class Parent>
  [[gnu::always_inline]] static void place(const Joint<S>& j, const S* q, const S* u, const Parent& p,
                                           Moving<S>& b) {
    b.R = in_hub(p, j.K0 * matrix_of_quaternion(q));
    b.r = in_hub(p, j.origin_p + Column<S>{q[4], q[5], q[6]});
    const Column<S> w_pb = b.R * Column<S>{u[0], u[1], u[2]};
    const Column<S> v_pb = in_hub(p, Column<S>{u[3], u[4], u[5]});
    b.w = p.w + w_pb;
    b.alpha0 = turned_with(p, w_pb);
    b.a0 = carried_by(p, b.r) + cross(p.w, v_pb) * S(2.0);
  }
  template <class S>
  static Accelerations<S> relative(const Square<S>& R_h_from_p, const S* udot, const Moving<S>& b) {
    return {b.R * Column<S>{udot[0], udot[1], udot[2]}, R_h_from_p * Column<S>{udot[3], udot[4], udot[5]}};
  }
  template <class S> static void rates(const S* q, const S* u, S* qdot) {
    quaternion_rate(q, u, qdot);
    qdot[4] = u[3], qdot[5] = u[4], qdot[6] = u[5];
  }

  template <class S> static void eliminate(const Square<S>& R_h_from_p, const S* effort, Moving<S>& b) {
    Articulated<S>& I = b.I;
    const Column<S> n = b.R * Column<S>{effort[0], effort[1], effort[2]};
    const Column<S> f = R_h_from_p * Column<S>{effort[3], effort[4], effort[5]};
    const Accelerations<S> own = solve_free(I, n, f);
    b.alpha_e = own.alpha;
    b.a_e = own.a;
    const Column<S> none = zero_column<S>();
    I = {diagonal(S(0.0)), {none, none, none}, diagonal(S(0.0)), n, f};
  }
  template <class S> static void advance(const Square<S>& R_h_from_p, Moving<S>& b, S* udot) {
    const Column<S> turning = transposed_times(b.R, b.alpha_e - b.alpha);
    const Column<S> moving = transposed_times(R_h_from_p, b.a_e - b.a);
    udot[0] = turning.x, udot[1] = turning.y, udot[2] = turning.z;
    udot[3] = moving.x, udot[4] = moving.y, udot[5] = moving.z;
    b.alpha = b.alpha_e;
    b.a = b.a_e;
  }
  template <class S> static Column<S> velocity(const Square<S>& R_h_from_p, const S* u, const Moving<S>&) {
    return R_h_from_p * Column<S>{u[3], u[4], u[5]};
  }
};

}  // namespace vectrix::multibody
