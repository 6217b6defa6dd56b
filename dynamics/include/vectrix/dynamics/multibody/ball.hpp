#pragma once

#include <vectrix/dynamics/multibody/joint.hpp>

namespace vectrix::multibody {

/// b turns freely about its origin. The four positions are q of R_0^-1 R_b^p, scalar first; the speeds are
/// w_pb^b; the efforts a torque in the axes of b. With all three turns free, A and H of the body vanish for
/// the parent: the joint transmits the effort n and a force, and
///     alpha = A^-1 (n - n0 - H a),   M' = M - H^T A^-1 H,   f0' = f0 + H^T A^-1 (n - n0)
struct Ball {
  static constexpr int positions = 4, speeds = 3;

  template <class S, class Parent>
  [[gnu::always_inline]] static void place(const Joint<S>& j, const S* q, const S* u, const Parent& p,
                                           Moving<S>& b) {
    b.R = in_hub(p, j.K0 * matrix_of_quaternion(q));
    b.r = in_hub(p, j.origin_p);
    const Column<S> w_pb = b.R * Column<S>{u[0], u[1], u[2]};
    b.w = p.w + w_pb;
    b.alpha0 = turned_with(p, w_pb);
    b.a0 = carried_by(p, b.r);
  }
  template <class S> static Accelerations<S> relative(const Square<S>&, const S* udot, const Moving<S>& b) {
    return {b.R * Column<S>{udot[0], udot[1], udot[2]}, zero_column<S>()};
  }
  template <class S> static void rates(const S* q, const S* u, S* qdot) { quaternion_rate(q, u, qdot); }

  template <class S> static void eliminate(const Square<S>&, const S* effort, Moving<S>& b) {
    Articulated<S>& I = b.I;
    const Column<S> n = b.R * Column<S>{effort[0], effort[1], effort[2]};
    const Symmetric<S> W = inverse(I.A);
    b.G = W * I.H;
    b.alpha_e = W * (n - I.n);
    I.n = n;
    I.f += transposed_times(I.H, b.alpha_e);
    I.M.xx -= dot(I.H.x, b.G.x), I.M.yy -= dot(I.H.y, b.G.y), I.M.zz -= dot(I.H.z, b.G.z);
    I.M.xy -= dot(I.H.x, b.G.y), I.M.xz -= dot(I.H.x, b.G.z), I.M.yz -= dot(I.H.y, b.G.z);
    I.A = diagonal(S(0.0));
    I.H = {zero_column<S>(), zero_column<S>(), zero_column<S>()};
  }
  template <class S> static void advance(const Square<S>&, Moving<S>& b, S* udot) {
    const Column<S> alpha = b.alpha_e - b.G * b.a;
    const Column<S> relative = transposed_times(b.R, alpha - b.alpha);
    udot[0] = relative.x, udot[1] = relative.y, udot[2] = relative.z;
    b.alpha = alpha;
  }
  template <class S> static Column<S> velocity(const Square<S>&, const S*, const Moving<S>&) {
    return zero_column<S>();
  }
};

}  // namespace vectrix::multibody
