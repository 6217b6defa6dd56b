#pragma once

#include <numbers>
#include <random>
#include <vector>
#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

/// Shared by the tests of rigid motions: screws of every regime, and power series of matrices as the
/// reference.
namespace vectrix_test {

template <int N> using ExtendedMatrix = Eigen::Matrix<long double, N, N>;
template <int N> using ExtendedColumn = Eigen::Matrix<long double, N, 1>;

/// The sum of M^n/(n + first)! in long double. Its terms grow to e^|M| before they decrease: up to one and a
/// half turns this costs 14 of 64 bits.
template <int N> ExtendedMatrix<N> power_series(const ExtendedMatrix<N>& M, int first) {
  ExtendedMatrix<N> term = ExtendedMatrix<N>::Identity();
  for (int k = 2; k <= first; ++k) term /= k;
  ExtendedMatrix<N> sum = term;
  int lost = 0;  // consecutive terms without effect; every second term may be zero
  for (int n = 1; n <= 80 && lost < 3; ++n) {
    term = (term * M / (n + first)).eval();
    const ExtendedMatrix<N> before = sum;
    sum += term;
    lost = sum == before ? lost + 1 : 0;
  }
  return sum;
}
/// The same matrices in long double, written out.
inline ExtendedMatrix<3> skew(const ExtendedColumn<3>& x) {
  ExtendedMatrix<3> m;
  m << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return m;
}
/// V^ = [[w]x v; 0 0]
inline ExtendedMatrix<4> four_by_four(const ExtendedColumn<6>& V) {
  ExtendedMatrix<4> m = ExtendedMatrix<4>::Zero();
  m.topLeftCorner<3, 3>() = skew(V.head<3>());
  m.topRightCorner<3, 1>() = V.tail<3>();
  return m;
}
inline ExtendedMatrix<6> bracket(const ExtendedColumn<6>& V) {
  ExtendedMatrix<6> m = ExtendedMatrix<6>::Zero();
  m.topLeftCorner<3, 3>() = skew(V.head<3>());
  m.bottomRightCorner<3, 3>() = skew(V.head<3>());
  m.bottomLeftCorner<3, 3>() = skew(V.tail<3>());
  return m;
}

/// Angles from 1e-300 to pi, including the angle where the series begins.
inline std::vector<double> angles_to_a_half_turn() {
  const double pi = std::numbers::pi;
  std::vector<double> angles{0.0, 1e-300, 0.5, 1.0, 2.0, 2.9999999, 3.0, 3.0000001, pi};
  for (double distance = 1e-1; distance > 1e-16; distance /= 10) angles.push_back(pi - distance);
  for (double angle = 0.3; angle > 1e-300; angle /= 47.3) angles.push_back(angle);
  return angles;
}
/// The same up to one and a half turns, without the full turn.
inline std::vector<double> angles_beyond() {
  const double full = 2 * std::numbers::pi;
  return {3.3, 4.0, 5.0, full - 0.1, full - 1e-3, full + 1e-3, full + 0.5, 8.0, 9.0};
}

/// (theta, rho) of the given angle: about axes, diagonals and oblique lines; rho along the axis,
/// perpendicular to it, in between, and zero. `size` of rho in m.
inline std::vector<Eigen::Matrix<double, 6, 1>> screws_of(double angle, double size) {
  const Eigen::Vector3d axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 1, 1}, {-1, 2, -3}, {1e-9, 0, 1}};
  const Eigen::Vector3d ways[] = {{0, 0, 0}, {0, 0, 1}, {0.5, 0, 0}, {0.3, -0.8, 0.6}};
  std::vector<Eigen::Matrix<double, 6, 1>> list;
  for (const auto& axis : axes) {
    const Eigen::Vector3d n = axis.normalized();
    const double half_turn = std::numbers::pi;
    Eigen::Vector3d theta = angle * n;
    // Rounding may have made it longer than half a turn; then the opposite rotation is shorter.
    while (angle <= half_turn && theta.cast<long double>().norm() > std::numbers::pi_v<long double>) {
      theta *= 1 - epsilon;
    }
    for (const auto& way : ways) list.emplace_back() << theta, size * way;
    list.emplace_back() << theta, size * n;
    list.emplace_back() << theta, size * n.unitOrthogonal();
  }
  return list;
}

inline vectrix::RotationVector<Gcrf, Body> turn_of(const Eigen::Vector3d& theta) {
  using namespace vectrix;
  return rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta));
}
inline vectrix::Screw<Gcrf, Body> screw_of(const Eigen::Matrix<double, 6, 1>& xi) {
  using namespace vectrix;
  return screw(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, xi.head<3>()),
               vector<si::length>(in<Gcrf>, xi.tail<3>()));
}
/// V_ab(p)^c of six numbers.
template <class A, class B, class P, class C>
vectrix::Twist<A, B, vectrix::At<P>, vectrix::In<C>> twist_with(const Eigen::Matrix<double, 6, 1>& V) {
  using namespace vectrix;
  return twist(at<P>,
               angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<C>, V.head<3>())),
               vector<si::velocity>(in<C>, V.tail<3>()));
}

template <class Derived> auto extended(const Eigen::MatrixBase<Derived>& m) {
  return m.template cast<long double>().eval();
}
/// The largest error of an entry, in units of the rounding of the largest.
template <class Found, class Exact>
double roundings(const Eigen::MatrixBase<Found>& found, const Eigen::MatrixBase<Exact>& exact) {
  const long double largest = exact.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  const long double error = (extended(found) - exact).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  return error == 0 ? 0.0 : static_cast<double>(error / (largest * epsilon));
}

}  // namespace vectrix_test
