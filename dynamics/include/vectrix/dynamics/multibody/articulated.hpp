#pragma once

#include <vectrix/dynamics/multibody/spatial.hpp>

namespace vectrix::multibody {

/// What is needed to move a body together with all that hangs on it, about the body's origin:
///     n = A alpha + H a + n0,   f = H^T alpha + M a + f0
/// with the wrench (n, f) that acts on it, N m and N, and the accelerations (alpha, a) beyond those at zero
/// joint accelerations, at which the wrench (n0, f0) is needed. Of a rigid body A = J, H = [mc]x, M = m 1.
template <class S> struct Articulated {
  Symmetric<S> A;
  Square<S> H;
  Symmetric<S> M;
  Column<S> n, f;
};

template <class S> struct Accelerations { Column<S> alpha, a; };
/// What a joint transmits to the body that hangs on it, about the body's origin.
template <class S> struct Transmitted { Column<S> force, torque; };

/// Takes one freedom out: its momentum (U, V) at unit speed, 1/D its inverse inertia, and e its acceleration
/// while the body is held.
///     A -= U U^T / D,  H -= U V^T / D,  M -= V V^T / D,  (n0, f0) += (U, V) e
template <class S>
[[gnu::always_inline]] inline void eliminate_one(Articulated<S>& I, const Column<S>& U, const Column<S>& V,
                                                 const S& inverse_D, const S& e) {
  const Column<S> UD = U * inverse_D, VD = V * inverse_D;
  I.A.subtract_outer(UD, U);
  I.M.subtract_outer(VD, V);
  I.H.x -= UD * V.x;
  I.H.y -= UD * V.y;
  I.H.z -= UD * V.z;
  I.n += U * e;
  I.f += V * e;
}

/// The accelerations (alpha, a) of the body itself are given beyond what it has now:
///     n0 += A alpha + H a,   f0 += H^T alpha + M a
template <class S> void add_acceleration(Articulated<S>& I, const Accelerations<S>& given) {
  I.n += I.A * given.alpha + I.H * given.a;
  I.f += transposed_times(I.H, given.alpha) + I.M * given.a;
}

/// Adds to the parent's what its child has about the point r from the parent's origin:
///     H' = H + r~ M,   A' = A - H r~ + r~ H'^T,   n' = n + r x f
template <class S>
[[gnu::always_inline]] inline void add_shifted(Articulated<S>& p, const Articulated<S>& c,
                                               const Column<S>& r) {
  const Square<S>& H = c.H;
  const Square<S> P{H.x + cross(r, Column<S>{c.M.xx, c.M.xy, c.M.xz}),
                    H.y + cross(r, Column<S>{c.M.xy, c.M.yy, c.M.yz}),
                    H.z + cross(r, Column<S>{c.M.xz, c.M.yz, c.M.zz})};
  // Entry (i, j) of -H r~ is that of r x row i of H; entry (i, j) of r~ P^T is entry i of r x row j of P.
  p.A.xx += c.A.xx + (r.y * H.z.x - r.z * H.y.x) + (r.y * P.z.x - r.z * P.y.x);
  p.A.yy += c.A.yy + (r.z * H.x.y - r.x * H.z.y) + (r.z * P.x.y - r.x * P.z.y);
  p.A.zz += c.A.zz + (r.x * H.y.z - r.y * H.x.z) + (r.x * P.y.z - r.y * P.x.z);
  p.A.xy += c.A.xy + (r.z * H.x.x - r.x * H.z.x) + (r.y * P.z.y - r.z * P.y.y);
  p.A.xz += c.A.xz + (r.x * H.y.x - r.y * H.x.x) + (r.y * P.z.z - r.z * P.y.z);
  p.A.yz += c.A.yz + (r.x * H.y.y - r.y * H.x.y) + (r.z * P.x.z - r.x * P.z.z);
  p.H.x += P.x;
  p.H.y += P.y;
  p.H.z += P.z;
  p.M += c.M;
  p.n += c.n + cross(r, c.f);
  p.f += c.f;
}

/// The accelerations of a body on which nothing acts but the wrench (n, f):
///     A alpha + H a + n0 = n,  H^T alpha + M a + f0 = f
template <class S>
[[gnu::always_inline]] inline Accelerations<S> solve_free(const Articulated<S>& I, const Column<S>& n,
                                                          const Column<S>& f) {
  const Column<S> torque = n - I.n, force = f - I.f;
  const Symmetric<S> W = inverse(I.M);
  const Square<S> T = product(I.H, W);  // H M^-1
  const Symmetric<S> E = times_transposed(T, I.H);
  const Symmetric<S> A{S(I.A.xx - E.xx), S(I.A.yy - E.yy), S(I.A.zz - E.zz),
                       S(I.A.xy - E.xy), S(I.A.xz - E.xz), S(I.A.yz - E.yz)};
  const Column<S> alpha = inverse(A) * (torque - T * force);
  return {alpha, W * (force - transposed_times(I.H, alpha))};
}

}  // namespace vectrix::multibody
