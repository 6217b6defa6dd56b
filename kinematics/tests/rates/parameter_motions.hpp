#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "testing/motions.hpp"

/// Moving parameters, compared with automatic differentiation of their matrix alone.
namespace vectrix_test {

using namespace vectrix;

template <class X> AngularVelocity<Gcrf, Body, In<X>> omega_of(const Eigen::Vector3d& w) {
  return angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<X>, w));
}
template <class X> AngularAcceleration<Gcrf, Body, In<X>> alpha_of(const Eigen::Vector3d& alpha) {
  return angular_acceleration(of<Body>, relative_to<Gcrf>, vector<si::angular_acceleration>(in<X>, alpha));
}

/// N numbers, their derivatives, and the motion of the matrix made from them.
template <int N> struct MovingNumbers {
  Eigen::Matrix<double, N, 1> value, first, second;
  Motion<Gcrf, Body> motion;

  MovingNumbers(const Eigen::Matrix<Dual2, N, 1>& numbers, const Dcm<Gcrf, Body, Dual2>& R_a_from_b)
      : value(numbers.unaryExpr([](const Dual2& n) { return vectrix_test::value(n); })),
        first(numbers.unaryExpr([](const Dual2& n) { return vectrix_test::first(n); })),
        second(numbers.unaryExpr([](const Dual2& n) { return vectrix_test::second(n); })),
        motion(R_a_from_b) {}
};

/// Three quadratics of the instant, with coefficients in [-size, size], [-1, 1], [-1, 1].
inline Eigen::Matrix<Dual2, 3, 1> quadratics(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Dual2 t = instant(0.3);
  Eigen::Matrix<Dual2, 3, 1> list;
  for (Dual2& q : list) {
    const Dual2 a = constant(size * number(random)), b = constant(number(random)),
                c = constant(number(random));
    q = a + b * t + c * t * t;
  }
  return list;
}

/// x is the parameters of numbers.value. `amplified` is the ratio of the derivatives to the rate.
template <class X, int N>
void expect_their_kinematics(const X& x, const MovingNumbers<N>& numbers, double amplified) {
  const auto xdot = parameter_rate(x, numbers.first);
  const auto xddot = second_parameter_rate(x, numbers.second);
  const auto check = [&]<class C>(In<C> in_c, const Eigen::Vector3d& w, const Eigen::Vector3d& alpha) {
    const double tolerance = motion_tolerance * std::max(1.0, w.squaredNorm() + alpha.norm());
    const AngularVelocity<Gcrf, Body, In<C>> w_c = angular_velocity_from(x, xdot, in_c);
    const AngularAcceleration<Gcrf, Body, In<C>> alpha_c = angular_acceleration_from(x, xdot, xddot, in_c);
    const auto forward = rate(x, omega_of<C>(w));
    const auto second = second_rate(x, omega_of<C>(w), alpha_of<C>(alpha));
    const double off[] = {(w_c.coordinates() - w).norm(), (alpha_c.coordinates() - alpha).norm(),
                          (forward.coordinates() - numbers.first).norm() / amplified,
                          (second.coordinates() - numbers.second).norm() / (amplified * amplified)};
    for (const double error : off) EXPECT_LE(error, tolerance);
  };
  const auto& exact = numbers.motion;
  check(in<Gcrf>, exact.w_a(), exact.alpha_a());
  check(in<Body>, exact.R.transpose() * exact.w_a(), exact.R.transpose() * exact.alpha_a());
}

}  // namespace vectrix_test
