#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <vectrix/kinematics/attitude/euler_sequence.hpp>

/// The 24 sequences of Euler angles, for typed tests, and the product of their rotations.
namespace vectrix_test {

using vectrix::Extrinsic;
using vectrix::Intrinsic;
using Sequences =
    testing::Types<Intrinsic<1, 2, 3>, Intrinsic<2, 3, 1>, Intrinsic<3, 1, 2>, Intrinsic<1, 3, 2>,
                   Intrinsic<2, 1, 3>, Intrinsic<3, 2, 1>, Intrinsic<1, 2, 1>, Intrinsic<1, 3, 1>,
                   Intrinsic<2, 1, 2>, Intrinsic<2, 3, 2>, Intrinsic<3, 1, 3>, Intrinsic<3, 2, 3>,
                   Extrinsic<1, 2, 3>, Extrinsic<2, 3, 1>, Extrinsic<3, 1, 2>, Extrinsic<1, 3, 2>,
                   Extrinsic<2, 1, 3>, Extrinsic<3, 2, 1>, Extrinsic<1, 2, 1>, Extrinsic<1, 3, 1>,
                   Extrinsic<2, 1, 2>, Extrinsic<2, 3, 2>, Extrinsic<3, 1, 3>, Extrinsic<3, 2, 3>>;

/// A sequence as numbers: its axes, and whether they are body-fixed (turn along).
struct Turns {
  std::array<int, 3> axes;
  bool intrinsic;
};
template <int I, int J, int K> Turns turns_of(Intrinsic<I, J, K>) {
  return {{I - 1, J - 1, K - 1}, true};
}
template <int I, int J, int K> Turns turns_of(Extrinsic<I, J, K>) {
  return {{I - 1, J - 1, K - 1}, false};
}

/// The matrix of the rotation by the angle about the axis.
template <class S> Eigen::Matrix<S, 3, 3> one_turn(int axis, const S& angle) {
  using std::cos;
  using std::sin;
  Eigen::Matrix<S, 3, 3> R = Eigen::Matrix<S, 3, 3>::Identity();
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  R(next, next) = R(last, last) = cos(angle);
  R(last, next) = sin(angle);
  R(next, last) = -R(last, next);
  return R;
}
/// R_b^a of the three rotations. A new rotation multiplies from the right if its axis is one of b, and from
/// the left if it is one of a.
template <class S> Eigen::Matrix<S, 3, 3> product_of(const Turns& turns, const Eigen::Matrix<S, 3, 1>& t) {
  Eigen::Matrix<S, 3, 3> R = Eigen::Matrix<S, 3, 3>::Identity();
  for (int n = 0; n < 3; ++n) {
    const Eigen::Matrix<S, 3, 3> turn = one_turn<S>(turns.axes[std::size_t(n)], t(n));
    R = turns.intrinsic ? (R * turn).eval() : (turn * R).eval();
  }
  return R;
}

}  // namespace vectrix_test
