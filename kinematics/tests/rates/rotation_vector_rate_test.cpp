// The rate and second rate of the rotation vector, by the Jacobians, compared with the derivatives of the
// rotation alone.
#include <gtest/gtest.h>

#include <vectrix/kinematics/attitude/jacobian.hpp>

#include "parameter_motions.hpp"
#include "screws/rigid_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace rotation_vector_rate_test {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// A rotation vector through theta at t = 0, with random derivatives of order 1.
MovingNumbers<3> through(const Vector3d& theta, std::mt19937_64& random) {
  const Dual2 t = instant(0.0);
  Eigen::Matrix<Dual2, 3, 1> moving;
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Dual2 rate = constant(number(random)), half_second = constant(number(random));
    moving(i) = constant(theta(i)) + t * rate + t * t * half_second;
  }
  return {moving, exp(rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, moving)))};
}

// Zero, the angles where the series begin, half a turn, and beyond a full turn, to which 6.2 rad is near.
TEST(RotationVectorRate, IsTheDerivativeInBothFramesAndBothWays) {
  std::mt19937_64 random(20260301);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (const double angle : {0.0, 1e-300, 1e-12, 1e-5, 0.00999, 0.01001, 0.3, 1.0, 2.0, 2.9999, 3.0001, pi,
                             4.0, 5.5, 6.2, 7.0, 20.0}) {
    const double distance_left = std::abs(2 * std::sin(angle / 2));
    const double amplified = angle < 1 ? 1 : 1 + angle / distance_left;
    for (int i = 0; i < 20; ++i) {
      const Vector3d axis = Vector3d(number(random), number(random), number(random)).normalized();
      const auto numbers = through(angle * axis, random);
      expect_their_kinematics(turn_of(numbers.value), numbers, amplified);
    }
  }
}

// w_ab^b = J_r theta_dot, w_ab^a = J_l theta_dot, and their inverses.
TEST(RotationVectorRate, TheJacobiansAreTheirMatrices) {
  std::mt19937_64 random(20260302);
  for (const double angle : {1e-9, 0.4, 2.9, 5.0}) {
    const auto numbers = through(angle * Vector3d(2, -1, 2) / 3, random);
    const auto theta = turn_of(numbers.value);
    const auto theta_dot = parameter_rate(theta, numbers.first);
    const auto w_b = angular_velocity_from(theta, theta_dot, in<Body>);
    const auto w_a = angular_velocity_from(theta, theta_dot, in<Gcrf>);
    EXPECT_LE(distance(w_b.coordinates(), right_jacobian(theta) * numbers.first), rounding);
    EXPECT_LE(distance(w_a.coordinates(), left_jacobian(theta) * numbers.first), rounding);
    EXPECT_LE(distance(rate(theta, w_b).coordinates(), inverse_right_jacobian(theta) * w_b.coordinates()),
              rounding);
    EXPECT_LE(distance(rate(theta, w_a).coordinates(), inverse_left_jacobian(theta) * w_a.coordinates()),
              rounding);
  }
}

// Bortz 1971: theta_dot = w + theta x w/2 + (1 - |theta|/2 cot |theta|/2) theta x (theta x w)/|theta|^2.
TEST(RotationVectorRate, IsBortzsEquation) {
  const Vector3d theta(0.7, -1.1, 0.4);
  const Vector3d w(0.3, 0.9, -0.6);
  const double half = theta.norm() / 2;
  const Vector3d bortz = w + theta.cross(w) / 2 +
                         (1 - half / std::tan(half)) / theta.squaredNorm() * theta.cross(theta.cross(w));
  EXPECT_LE(distance(rate(turn_of(theta), omega_of<Body>(w)).coordinates(), bortz), rounding);
  // In the other frame the sign of the second term is opposite.
  EXPECT_GT(distance(rate(turn_of(theta), omega_of<Gcrf>(w)).coordinates(), bortz), visible);
}

// theta_ba = -theta_ab, and the same for its rates; w_ba = -w_ab.
TEST(RotationVectorRate, Reverses) {
  std::mt19937_64 random(20260303);
  const auto numbers = through({0.3, -0.8, 1.1}, random);
  const RotationVector<Gcrf, Body> theta_ab = turn_of(numbers.value);
  const RotationVector<Body, Gcrf> theta_ba = -theta_ab;
  const auto w_ab_a = angular_velocity_from(theta_ab, parameter_rate(theta_ab, numbers.first), in<Gcrf>);
  const Vector3d reversed = -numbers.first;
  const auto w_ba_a = angular_velocity_from(theta_ba, parameter_rate(theta_ba, reversed), in<Gcrf>);
  EXPECT_LE(distance(w_ba_a.coordinates(), -w_ab_a.coordinates()), rounding);
}

TEST(RotationVectorRate, AtAFullTurnIsBadInputThatSaysHowNear) {
  const auto theta = turn_of({0, 0, 2 * pi});
  const auto w = omega_of<Body>({1, 0, 0});
  const auto text = message<BadInput>([&] { rate(theta, w); });
  EXPECT_TRUE(contains(text, "rate(rotation vector of ")) << text;
  EXPECT_TRUE(contains(text, "e-16 rad from the singularity, a full turn")) << text;
  EXPECT_TRUE(contains(message<BadInput>([&] {
                         second_rate(theta, w, alpha_of<Body>({0, 1, 0}));
                       }),
                       "rad from the singularity, a full turn"));
  // The inverse map has full accuracy there.
  const auto there = angular_velocity_from(theta, parameter_rate(theta, Vector3d(1, 2, 3)), in<Body>);
  EXPECT_LE(distance(there.coordinates(), Vector3d(0, 0, 3)), rounding);
}

TEST(RotationVector, SaysHowFarFromAFullTurnItIs) {
  const Vector3d axis = Vector3d(2, -1, 2) / 3;
  const auto distance_of = [&](double angle) {
    return turn_of(angle * axis).distance_from_singularity().value();
  };
  for (const double angle : {0.0, 1e-200, 0.5, 3.0, 3.3, 6.2, 2 * pi - 1e-9}) {
    EXPECT_NEAR(distance_of(angle), 2 * pi - angle, 4 * rounding);
  }
  for (const double beyond : {1e-9, 0.5, 3.0}) {
    EXPECT_NEAR(distance_of(2 * pi + beyond), beyond, 4 * rounding);
    EXPECT_NEAR(distance_of(4 * pi - beyond), beyond, 8 * rounding);
    EXPECT_NEAR(distance_of(4 * pi + beyond), beyond, 8 * rounding);
  }
}

// d|theta| = n . dtheta, for any size; at zero there is no derivative.
TEST(RotationVector, TheDerivativeOfItsAngleIsAlongTheAxis) {
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  const auto slope = [](const Vector3d& theta) {
    const Eigen::Matrix<Dual, 3, 1> moving(Dual(theta.x()), Dual(theta.y(), 1, 0), Dual(theta.z()));
    return rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, moving))
        .angle()
        .value()
        .derivatives()(0);
  };
  for (const double size : {1.0, 1e-200, 1e155}) {
    EXPECT_NEAR(slope(size * Vector3d(0.6, 0.8, 0)), 0.8, rounding);
    EXPECT_NEAR(slope(size * Vector3d(0, -1, 0)), -1, rounding);
  }
  EXPECT_TRUE(std::isnan(slope(Vector3d::Zero())));
}

}  // namespace
}  // namespace rotation_vector_rate_test
