#pragma once

#include <string>
#include <vector>
#include <vectrix/frames.hpp>
#include <vectrix/kinematics/attitude/log.hpp>

#include "table.hpp"

/// The subjects of the rows: two or three frames, and the library's quantities made from plain numbers of any
/// scalar.
namespace vectrix::accuracy {

struct A : inertial_frame {};
struct B : moving_frame {};
struct C : moving_frame {};
struct D : moving_frame {};

template <class S> using ColumnOf = Eigen::Matrix<S, 3, 1>;
template <class S> using SquareOf = Eigen::Matrix<S, 3, 3>;
template <class S> using FourOf = Eigen::Matrix<S, 4, 1>;

template <class S> RotationVector<A, B, S> theta_of(const ColumnOf<S>& numbers) {
  return rotation_vector(of<B>, relative_to<A>, vector<si::angle>(in<A>, numbers));
}
/// Scalar last.
template <class To, class From, class S> Quaternion<To, From, S> q_of(const FourOf<S>& q) {
  return quaternion_scalar_last(to<To>, from<From>, q(0), q(1), q(2), q(3));
}
template <class To, class From, class S> Dcm<To, From, S> R_of(const SquareOf<S>& matrix) {
  return trust_dcm(to<To>, from<From>, matrix);
}
inline WideQuaternion wide_quaternion(const Eigen::Vector4d& q) {
  return WideQuaternion(widened(q));
}

/// A kind of turns; `draw` gives the rotation vector.
struct Turns {
  std::string name;
  Eigen::Vector3d (*draw)(Draw&);
  std::size_t count;
};
/// tiny, small, any, near half a turn, at half a turn, special.
const std::vector<Turns>& turns();

/// The double matrix nearest to exp(theta), and the double quaternion, scalar last.
Eigen::Matrix3d rounded_dcm(const Eigen::Vector3d& theta);
Eigen::Vector4d rounded_quaternion(const Eigen::Vector3d& theta);
/// Any rotation.
inline Eigen::Matrix3d any_dcm(Draw& draw) {
  return rotation_of(wide_quaternion(draw.quaternion())).cast<double>();
}

/// f in double against f of the same numbers in Wide: rounding alone.
template <class F, class... X>
Found rounding(const F& f, Wide scale, const char* place, double value, const X&... x) {
  return compare(f(x...), f(widened(x)...), scale, place, value);
}

/// q and -q are the same rotation.
inline Found compare_up_to_sign(const Eigen::Vector4d& computed, const WideQuaternion& exact,
                                const char* place, double value) {
  const Eigen::Matrix<Wide, 4, 1> same = widened(computed), opposite = -same;
  const Found one = compare(same, exact.coeffs(), 1, place, value);
  const Found other = compare(opposite, exact.coeffs(), 1, place, value);
  return one.ulps < other.ulps ? one : other;
}
/// Compares rotation vectors: near half a turn, theta and theta - 2 pi n are the same.
inline Found compare_turns(const Eigen::Vector3d& computed, const WideColumn& exact) {
  const Wide angle = exact.norm();
  const double value = static_cast<double>(angle);
  const Found one = compare(computed, exact, angle, "angle", value);
  if (angle < 3.14L) return one;
  const WideColumn longer = exact - 2 * pi / angle * exact;
  const Found other = compare(computed, longer, angle, "angle", value);
  return one.ulps < other.ulps ? one : other;
}

}  // namespace vectrix::accuracy
