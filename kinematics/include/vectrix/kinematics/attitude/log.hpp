#pragma once

#include <cmath>
#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/frames/scalar/square_root.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/attitude/rotation_vector.hpp>

namespace vectrix {
namespace detail {

/// |theta| / |v| of the shortest turn, from q_w >= 0 and |v|^2, where q = (q_w, v).
template <class S> S turn_factor(const S& scalar, const S& square) {
  const S length = square_root(square);
  return S(2) * arc_tangent(length, scalar) / length;
}
/// The same for |v|^2 < 1e-4, 2 atan(t)/t / w with t^2 = |v|^2 / w^2; the first omitted term is below 1e-17.
template <class S> S turn_factor_series(const S& scalar, const S& square) {
  const S inverse = S(1) / scalar;
  const S t2 = square * inverse * inverse;
  return S(2) * inverse *
         (S(1) - t2 * (S(1) / S(3) -
                       t2 * (S(1) / S(5) - t2 * (S(1) / S(7) - t2 * (S(1) / S(9) - t2 * (S(1) / S(11)))))));
}

}  // namespace detail

/// log: the rotation vector theta_ab of the shortest turn, |theta| <= pi, with exp(theta_ab) = q_a_from_b.
/// Accurate to rounding from 1e-300 rad to pi. At exactly pi, where n and -n are the same rotation, the first
/// non-zero component of the axis is positive. The identity gives zero. Any unit quaternion is valid.
template <class A, class B, class S> RotationVector<A, B, S> log(const Quaternion<A, B, S>& q_a_from_b) {
  using detail::select;
  const auto& q = q_a_from_b.eigen();
  const detail::Column<S> v = q.vec();
  const auto flipped = detail::is_longer_way(q);
  const S scalar = select<S>(flipped, -q.w(), q.w());
  const S square = v.squaredNorm();
  S factor = detail::turn_factor_series(scalar, square);
  if (const auto small = square < detail::number<S>(1e-4); !detail::all(small)) {
    factor = select(small, factor, detail::turn_factor(scalar, square));
  }
  return {detail::trusted, select<S>(flipped, -factor, factor) * v};
}

/// log of a DCM, with the same range, accuracy and choice of axis. If cos |theta| > -1/2 it uses tan |theta|
/// = |vee(R - R^T)| / (tr R - 1), else the quaternion.
template <class A, class B, class S> RotationVector<A, B, S> log(const Dcm<A, B, S>& R_a_from_b) {
  if constexpr (!detail::Batch<S>) {
    const auto& m = R_a_from_b.matrix();
    if (const S trace = m(0, 0) + m(1, 1) + m(2, 2); trace > S(0)) {
      const detail::Column<S> v(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
      const S square = v.squaredNorm();
      const S scalar = trace - S(1);
      const S factor =
          square < S(1e-4) ? detail::turn_factor_series(scalar, square) : detail::turn_factor(scalar, square);
      return {detail::trusted, factor / S(2) * v};
    }
  }
  return log(quaternion(R_a_from_b));
}

}  // namespace vectrix
