#include <gtest/gtest.h>

#include <vectrix/kinematics/rates/euler_rates.hpp>

#include "attitude/sequences.hpp"
#include "parameter_motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace euler_rates_test {
namespace {

constexpr int instances = 100;

template <class Sequence> EulerAngles<Sequence, Gcrf, Body> angles_of(const Eigen::Vector3d& t) {
  return euler_angles(Sequence{}, of<Body>, relative_to<Gcrf>, t(0) * si::radian, t(1) * si::radian,
                      t(2) * si::radian);
}

/// Outside the typed test, so that automatic differentiation is compiled once and not 24 times.
MovingNumbers<3> moving_angles(std::mt19937_64& random, const Turns& turns) {
  const Eigen::Matrix<Dual2, 3, 1> t = quadratics(random, 3.0);
  return {t, trust_dcm(to<Gcrf>, from<Body>, product_of(turns, t))};
}

/// Each order of axes once, and proper or not, cyclic or not, intrinsic and extrinsic. The rates name an axis
/// only to turn about it: of an order the other kind can find nothing that this list does not.
using RateSequences =
    testing::Types<Intrinsic<1, 2, 3>, Extrinsic<2, 3, 1>, Intrinsic<3, 1, 2>, Extrinsic<1, 3, 2>,
                   Extrinsic<2, 1, 3>, Intrinsic<3, 2, 1>, Intrinsic<1, 2, 1>, Intrinsic<1, 3, 1>,
                   Extrinsic<2, 1, 2>, Extrinsic<2, 3, 2>, Intrinsic<3, 1, 3>, Extrinsic<3, 2, 3>>;
template <class Sequence> class EulerRates : public testing::Test {};
TYPED_TEST_SUITE(EulerRates, RateSequences);

TYPED_TEST(EulerRates, AreTheDerivativesInBothFramesAndBothWays) {
  std::mt19937_64 random(20261101);
  for (int i = 0; i < instances; ++i) {
    const auto numbers = moving_angles(random, turns_of(TypeParam{}));
    const auto x = angles_of<TypeParam>(numbers.value);
    const double away = x.distance_from_singularity().value();
    if (away > 0.05) expect_their_kinematics(x, numbers, 1 / away);
  }
}

// The loss of digits follows the distance: a rate of 1 rad/s is a rate of 1/distance of the first and third
// angle.
TYPED_TEST(EulerRates, NearTheSingularityOnlyAsManyDigitsGoAsItIsNear) {
  for (const double away : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double second = (TypeParam::proper ? 0.0 : std::numbers::pi / 2) + away;
    const auto x = angles_of<TypeParam>(Eigen::Vector3d(0.4, second, -1.2));
    const Eigen::Vector3d w(0.3, -0.7, 0.5);
    const auto xdot = rate(x, omega_of<Body>(w));
    const double spoilt = 16 * epsilon / away;
    EXPECT_LE(distance(angular_velocity_from(x, xdot, in<Body>).coordinates(), w), spoilt);
    EXPECT_NEAR(x.distance_from_singularity().value(), away, epsilon);
  }
}

TYPED_TEST(EulerRates, AtTheSingularityAreBadInputThatSaysHowNear) {
  const double second = TypeParam::proper ? 0.0 : std::numbers::pi / 2;
  const auto x = angles_of<TypeParam>(Eigen::Vector3d(0.4, second, -1.2));
  const auto w = omega_of<Gcrf>({1, 2, 3});
  const auto text = message<BadInput>([&] { rate(x, w); });
  EXPECT_TRUE(contains(text, "rate(Euler angles " + TypeParam::name() + " of ")) << text;
  EXPECT_TRUE(contains(text, "Body relative to ") && contains(text, "Gcrf): ")) << text;
  EXPECT_TRUE(contains(text, TypeParam::proper ? "): 0 rad from the singularity, the second angle none"
                                               : "): 6.123233995736766e-17 rad from the singularity"))
      << text;
  const auto again = message<BadInput>([&] { second_rate(x, w, alpha_of<Gcrf>({1, 2, 3})); });
  EXPECT_NE(again, "");
  // The inverse map is regular there.
  const auto xdot = parameter_rate(x, 1.0 * si::radian / si::second, 0.0 * si::radian / si::second,
                                   1.0 * si::radian / si::second);
  const double both = angular_velocity_from(x, xdot, in<Gcrf>).coordinates().norm();
  // The first and the third axis are parallel, of one sense or opposite.
  const auto turns = turns_of(TypeParam{});
  const bool cyclic = (turns.axes[0] + 1) % 3 == turns.axes[1];
  EXPECT_NEAR(both, TypeParam::proper || cyclic == turns.intrinsic ? 2.0 : 0.0, rounding);
}

// Note 003: R = Rx(alpha) Ry(beta) Rz(gamma), the rate in the outer frame a:
//     w = [1 0 sin b; 0 cos a -sin a cos b; 0 sin a cos a cos b] (alpha', beta', gamma')
TEST(Euler123, ItsMatrixInTheOuterFrame) {
  const double a = 0.7, b = -0.4, g = 2.1;
  const auto x = angles_of<Intrinsic<1, 2, 3>>(Eigen::Vector3d(a, b, g));
  Eigen::Matrix3d note;
  note << 1, 0, std::sin(b), 0, std::cos(a), -std::sin(a) * std::cos(b), 0, std::sin(a),
      std::cos(a) * std::cos(b);
  for (int i = 0; i < 3; ++i) {
    const auto xdot = parameter_rate(x, Eigen::Vector3d::Unit(i));
    EXPECT_LE(distance(angular_velocity_from(x, xdot, in<Gcrf>).coordinates(), note.col(i)), rounding);
  }
  const Eigen::Vector3d w(0.3, -0.2, 0.9);
  EXPECT_LE(distance(rate(x, omega_of<Gcrf>(w)).coordinates(), note.inverse() * w), rounding);
}

// Note 000: w^b is the rate with Rdot = R [w^b]x. For the same product, its matrix is
//     [cos b cos c sin c 0; -cos b sin c cos c 0; sin b 0 1]
TEST(Euler123, ItsMatrixInTheBody) {
  const double b = -0.4, g = 2.1;
  const auto x = angles_of<Intrinsic<1, 2, 3>>(Eigen::Vector3d(0.7, b, g));
  Eigen::Matrix3d body;
  body << std::cos(b) * std::cos(g), std::sin(g), 0, -std::cos(b) * std::sin(g), std::cos(g), 0, std::sin(b),
      0, 1;
  for (int i = 0; i < 3; ++i) {
    const auto xdot = parameter_rate(x, Eigen::Vector3d::Unit(i));
    const auto w_b = angular_velocity_from(x, xdot, in<Body>);
    const auto w_a = angular_velocity_from(x, xdot, in<Gcrf>);
    EXPECT_LE(distance(w_b.coordinates(), body.col(i)), rounding);
    EXPECT_LE(distance((dcm(x) * w_b).coordinates(), w_a.coordinates()), rounding);
    EXPECT_LE(distance(rate(dcm(x), w_b).matrix(), dcm(x).matrix() * hat(Eigen::Vector3d(body.col(i)))),
              rounding);
  }
}

// Note 003: R = Rz(theta) Rx(rho), w = (rho' cos theta, rho' sin theta, theta') in the outer frame.
TEST(Euler312, WithoutAThirdTurnIsThePairOfTheNote) {
  const double theta = 0.8, rho = -1.1, theta_dot = 0.3, rho_dot = -0.5;
  const auto x = angles_of<Intrinsic<3, 1, 2>>(Eigen::Vector3d(theta, rho, 0.0));
  const auto xdot = parameter_rate(x, Eigen::Vector3d(theta_dot, rho_dot, 0.0));
  const Eigen::Vector3d note(rho_dot * std::cos(theta), rho_dot * std::sin(theta), theta_dot);
  EXPECT_LE(distance(angular_velocity_from(x, xdot, in<Gcrf>).coordinates(), note), rounding);
}

// Yaw, pitch and roll of an aircraft: p = roll' - yaw' sin pitch, and so on.
TEST(Euler321, IsThatOfTextbooks) {
  const double pitch = 0.4, roll = -0.9;
  const auto x = angles_of<Intrinsic<3, 2, 1>>(Eigen::Vector3d(1.3, pitch, roll));
  const double yaw_dot = 0.2, pitch_dot = -0.3, roll_dot = 0.7;
  const auto w_b =
      angular_velocity_from(x, parameter_rate(x, Eigen::Vector3d(yaw_dot, pitch_dot, roll_dot)), in<Body>);
  EXPECT_NEAR(w_b.coordinates().x(), roll_dot - yaw_dot * std::sin(pitch), rounding);
  EXPECT_NEAR(w_b.coordinates().y(), pitch_dot * std::cos(roll) + yaw_dot * std::cos(pitch) * std::sin(roll),
              rounding);
  EXPECT_NEAR(w_b.coordinates().z(), yaw_dot * std::cos(pitch) * std::cos(roll) - pitch_dot * std::sin(roll),
              rounding);
}

TEST(EulerRate, ItsDoorTakesFiniteNumbers) {
  const auto x = angles_of<Intrinsic<3, 2, 1>>(Eigen::Vector3d(1.3, 0.2, 0.1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto text = message<BadInput>([&] { parameter_rate(x, Eigen::Vector3d(1, nan, 2)); });
  EXPECT_TRUE(contains(text, "parameter_rate(Euler angles intrinsic 3-2-1 of ")) << text;
  EXPECT_TRUE(contains(text, "the numbers (1, nan, 2) are not finite")) << text;
  EXPECT_NE(message<BadInput>([&] { second_parameter_rate(x, Eigen::Vector3d(1, nan, 2)); }), "");
}

TEST(EulerRate, SaysWhatItIs) {
  const auto x = angles_of<Intrinsic<3, 2, 1>>(Eigen::Vector3d(1.3, 0.2, 0.1));
  std::ostringstream out;
  out << parameter_rate(x, Eigen::Vector3d(1, 2, 3)) << "; "
      << second_parameter_rate(x, Eigen::Vector3d(4, 5, 6));
  const std::string whose =
      "Euler angles intrinsic 3-2-1 of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>();
  EXPECT_EQ(out.str(), "(1, 2, 3) rad/s, " + whose + "; (4, 5, 6) rad/s^2, " + whose);
}

}  // namespace
}  // namespace euler_rates_test
