#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <optional>
#include <random>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace quaternion_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class B, class A> Quaternion<B, A> any_quaternion() {
  const auto q = *attitude();
  return quaternion_scalar_first(to<B>, from<A>, q.w(), q.x(), q.y(), q.z());
}

// 1. r^b = q r^a q*, equal to R_a^b r^a.
RC_GTEST_PROP(Quaternion, Law1MapsCoordinatesAsItsDcm, ()) {
  const auto q_b_from_a = any_quaternion<Body, Gcrf>();
  const auto r_a = vector<si::length>(in<Gcrf>, *triple());
  const Vector<Body, si::length> r_b = q_b_from_a * r_a;
  const Dcm<Body, Gcrf> R_b_from_a = dcm(q_b_from_a);
  RC_ASSERT(distance(r_b.coordinates(), (R_b_from_a * r_a).coordinates()) <= rounding);
  const Eigen::Quaterniond pure(0, r_a.x().value(), r_a.y().value(), r_a.z().value());
  const Eigen::Quaterniond product = q_b_from_a.eigen() * pure * q_b_from_a.eigen().conjugate();
  RC_ASSERT(distance(r_b.coordinates(), product.vec()) <= rounding);
}

TEST(Quaternion, OfEigenComesInAndGoesOut) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3).normalized();
  const auto q_b_from_a = quaternion(to<Body>, from<Gcrf>, q);
  EXPECT_EQ(q_b_from_a.eigen().coeffs(), q.coeffs());
  EXPECT_EQ(q_b_from_a.scalar_first()[0], q.w());
  const Eigen::Quaternionf half(0, 0, 2, 0);
  const auto nearest = nearest_quaternion(to<Body>, from<Gcrf>, half);
  EXPECT_EQ(nearest.quaternion.eigen().coeffs(), Eigen::Vector4f(0, 1, 0, 0));
  EXPECT_EQ(nearest.distance, 1.0f);
  EXPECT_TRUE(contains(message<BadInput>([&] { quaternion(to<Body>, from<Gcrf>, half); }),
                       "the norm differs from 1 by 1, tolerance "));
  EXPECT_TRUE(
      contains(message<BadInput>([&] { quaternion(to<Body>, from<Gcrf>, Eigen::Quaterniond(nan, 0, 0, 1)); }),
               "quaternion(to<"));
}

// 2. q_a^c = q_b^c q_a^b.
RC_GTEST_PROP(Quaternion, Law2InnerFramesCancel, ()) {
  const auto q_c_from_b = any_quaternion<Camera, Body>();
  const auto q_b_from_a = any_quaternion<Body, Gcrf>();
  const Quaternion<Camera, Gcrf> q_c_from_a = q_c_from_b * q_b_from_a;
  const auto r_a = vector<si::length>(in<Gcrf>, *triple());
  RC_ASSERT(distance(dcm(q_c_from_a).matrix(), (dcm(q_c_from_b) * dcm(q_b_from_a)).matrix()) <= rounding);
  RC_ASSERT(distance((q_c_from_a * r_a).coordinates(), (q_c_from_b * (q_b_from_a * r_a)).coordinates()) <=
            rounding);
  RC_ASSERT(distance(dcm(inverse(q_b_from_a)).matrix(), inverse(dcm(q_b_from_a)).matrix()) <= rounding);
}

TEST(Quaternion, Law2IsNotTheReversedProduct) {
  const auto q_c_from_b = quaternion_scalar_first(to<Camera>, from<Body>, 0.5, 0.5, -0.5, 0.5);
  const auto q_b_from_a = quaternion_scalar_first(to<Body>, from<Gcrf>, 0.6, 0.0, 0.8, 0.0);
  const Eigen::Matrix3d reversed = dcm(q_b_from_a).matrix() * dcm(q_c_from_b).matrix();
  EXPECT_GT(distance(dcm(q_c_from_b * q_b_from_a).matrix(), reversed), visible);
}

// 3. q and -q are the same rotation.
RC_GTEST_PROP(Quaternion, Law3TheSignDoesNotMatter, ()) {
  const auto q = *attitude();
  const auto plus = quaternion_scalar_first(to<Body>, from<Gcrf>, q.w(), q.x(), q.y(), q.z());
  const auto minus = quaternion_scalar_first(to<Body>, from<Gcrf>, -q.w(), -q.x(), -q.y(), -q.z());
  RC_ASSERT(dcm(plus).matrix() == dcm(minus).matrix());
}

bool canonical(const std::array<double, 4>& q) {
  for (const double c : q) {
    if (c != 0.0) return c > 0.0;
  }
  return false;
}

RC_GTEST_PROP(Quaternion, ThatOfADcmIsAccurateForEveryRotation, ()) {
  const auto R = trust_dcm(to<Body>, from<Gcrf>, *rotation_matrix());
  const auto q = quaternion(R);
  RC_ASSERT(distance(dcm(q).matrix(), R.matrix()) <= rounding);
  RC_ASSERT(std::abs(q.eigen().norm() - 1.0) <= rounding);
  RC_ASSERT(canonical(q.scalar_first()));
}

TEST(Quaternion, TheWayByTheDcmKeepsEveryNumber) {
  for (const auto& given : hard_attitudes()) {
    const auto q = quaternion_scalar_first(to<Body>, from<Gcrf>, given.w(), given.x(), given.y(), given.z());
    const Eigen::Vector4d back = quaternion(dcm(q)).eigen().coeffs();
    EXPECT_LE(std::min(distance(back, given.coeffs()), distance(back, -given.coeffs())), rounding)
        << given.coeffs().transpose();
  }
}

TEST(Quaternion, AQuarterTurnAboutZHasItsPublishedNumbers) {
  // b is a turned by 90 degrees about z: q_a_from_b = (cos 45, 0, 0, sin 45), scalar first.
  const auto R_b_from_a = turned_z(to<Body>, from<Gcrf>, std::numbers::pi / 2 * si::radian);
  const auto q = quaternion(inverse(R_b_from_a)).scalar_first();
  EXPECT_NEAR(q[0], std::numbers::sqrt2 / 2, rounding);
  EXPECT_NEAR(q[3], std::numbers::sqrt2 / 2, rounding);
  EXPECT_NEAR(q[1], 0.0, rounding);
  EXPECT_NEAR(q[2], 0.0, rounding);
}

TEST(Quaternion, TheDoorsSayWhereTheScalarIs) {
  const auto first = quaternion_scalar_first(to<Body>, from<Gcrf>, 0.1, 0.5, -0.7, 0.5);
  const auto last = quaternion_scalar_last(to<Body>, from<Gcrf>, 0.5, -0.7, 0.5, 0.1);
  EXPECT_EQ(first.scalar_first(), (std::array{0.1, 0.5, -0.7, 0.5}));
  EXPECT_EQ(first.scalar_last(), (std::array{0.5, -0.7, 0.5, 0.1}));
  EXPECT_EQ(last.scalar_first(), first.scalar_first());
  EXPECT_EQ(first.eigen().w(), 0.1);
}

TEST(Quaternion, BadNumbersAreBadInput) {
  const auto none =
      message<BadInput>([] { quaternion_scalar_first(to<Body>, from<Gcrf>, 0.0, 0.0, 0.0, 0.0); });
  EXPECT_TRUE(contains(none, "quaternion_scalar_first(to<")) << none;
  EXPECT_TRUE(contains(none, "the norm is 0; a zero quaternion turns nothing")) << none;
  const auto not_a_number =
      message<BadInput>([] { quaternion_scalar_last(to<Body>, from<Gcrf>, 0.0, nan, 0.0, 1.0); });
  EXPECT_TRUE(contains(not_a_number, "quaternion_scalar_last(to<")) << not_a_number;
  EXPECT_TRUE(contains(not_a_number, "Body>, from<") && contains(not_a_number, "Gcrf>): ")) << not_a_number;
  EXPECT_TRUE(contains(not_a_number, "the numbers, scalar first, (1, 0, nan, 0) are not finite"))
      << not_a_number;
  const auto rounded =
      message<BadInput>([] { quaternion_scalar_first(to<Body>, from<Gcrf>, 1.5, 0.0, 0.0, 0.0); });
  EXPECT_TRUE(contains(rounded, "the norm differs from 1 by 0.5, tolerance 1.2e-10")) << rounded;
  EXPECT_TRUE(contains(rounded, "nearest_quaternion_scalar_first() projects")) << rounded;
  EXPECT_NE(
      message<BadInput>([] { nearest_quaternion_scalar_last(to<Body>, from<Gcrf>, 0.0, 0.0, 0.0, 0.0); }),
      "");
  EXPECT_NE(
      message<BadInput>([] { nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, nan, 0.0, 0.0, 0.0); }),
      "");
}

TEST(Quaternion, TheToleranceIsThatOfTenPrintedDigits) {
  const auto door = [](double w) {
    return message<BadInput>([=] { quaternion_scalar_first(to<Body>, from<Gcrf>, w, 0.0, 0.0, 0.0); });
  };
  EXPECT_EQ(door(1 + 0.9 * unit_norm_tolerance), "");
  EXPECT_NE(door(1 + 1.1 * unit_norm_tolerance), "");
  EXPECT_EQ(door(1 - 0.9 * unit_norm_tolerance), "");
  EXPECT_NE(door(1 - 1.1 * unit_norm_tolerance), "");
}

TEST(Quaternion, TenPrintedDigitsPassTheDoor) {
  std::mt19937_64 random(20261129);
  std::normal_distribution<double> number;
  const auto printed = [](double x) { return std::round(x * 1e10) / 1e10; };
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector4d q =
        Eigen::Vector4d(number(random), number(random), number(random), number(random)).normalized();
    EXPECT_EQ(message<BadInput>([&] {
                quaternion_scalar_first(to<Body>, from<Gcrf>, printed(q(0)), printed(q(1)), printed(q(2)),
                                        printed(q(3)));
              }),
              "");
  }
}

template <class S> void expect_the_dcm_door_accepts(S off) {
  std::mt19937_64 random(20261128);
  std::normal_distribution<double> number;
  int accepted = 0;
  for (int i = 0; i < 1000; ++i) {
    Eigen::Matrix<S, 4, 1> q;
    for (S& x : q) x = static_cast<S>(number(random));
    if (i % 2 == 0) q(0) = 0;  // half a turn, where the error of the matrix is largest
    q *= (1 + off) / q.norm();
    std::optional<Quaternion<Body, Gcrf, S>> typed;
    const auto door = [&] { typed = quaternion_scalar_first(to<Body>, from<Gcrf>, q(0), q(1), q(2), q(3)); };
    if (!message<BadInput>(door).empty()) continue;
    ++accepted;
    const auto R = dcm(*typed);
    EXPECT_EQ(message<BadInput>([&] { dcm(to<Body>, from<Gcrf>, R.matrix()); }), "") << q.transpose();
  }
  EXPECT_GT(accepted, 300);  // at the tolerance rounding decides
}

TEST(Quaternion, WhatItsDoorAcceptsTheDcmDoorAccepts) {
  for (const double part : {-0.999, -0.5, 0.5, 0.999}) {
    expect_the_dcm_door_accepts<double>(part * unit_norm_tolerance);
    expect_the_dcm_door_accepts<long double>(part * unit_norm_tolerance);
    expect_the_dcm_door_accepts<float>(
        static_cast<float>(part * detail::door_tolerance<float>(unit_norm_tolerance)));
  }
}

// Kept as given, factors at the tolerance make products beyond it: their numbers need the projecting door,
// and everything else takes the typed values.
TEST(Quaternion, ErrorsOfFactorsAddInAProduct) {
  const double off = 0.9 * unit_norm_tolerance;
  const Eigen::Quaterniond half_turn(0.0, 0.6 * (1 + off), 0.0, 0.8 * (1 + off));
  const auto q = quaternion(to<Body>, from<Gcrf>, half_turn);
  EXPECT_EQ(q.eigen().coeffs(), half_turn.coeffs());
  const auto again = q * inverse(q);
  EXPECT_NEAR(again.eigen().norm() - 1, 2 * off, rounding);
  const auto numbers = again.eigen();
  EXPECT_TRUE(contains(message<BadInput>([&] { quaternion(to<Body>, from<Camera>, numbers); }),
                       "nearest_quaternion() projects"));
  EXPECT_LE(nearest_quaternion(to<Body>, from<Camera>, numbers).distance, 2 * off + rounding);

  auto product = again * q;
  for (int i = 0; i < 8; ++i) product = product * inverse(q) * q;
  const auto R = dcm(product);
  EXPECT_TRUE(
      contains(message<BadInput>([&] { dcm(to<Body>, from<Gcrf>, R.matrix()); }), "nearest_dcm() projects"));
  const double error = 8 * 19 * off;  // of R^T R - I
  EXPECT_LE(nearest_dcm(to<Body>, from<Gcrf>, R.matrix()).distance, error);
  EXPECT_LE(std::abs(quaternion(R).eigen().norm() - 1), rounding);
  EXPECT_LE(distance(dcm(quaternion(R)).matrix(), dcm(q).matrix()), error);
}

TEST(Quaternion, TheProjectingDoorsSayHowFar) {
  const auto first = nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, 3.0, 0.0, 4.0, 0.0);
  EXPECT_EQ(first.distance, 4.0);
  EXPECT_EQ(first.quaternion.scalar_first(), (std::array{0.6, 0.0, 0.8, 0.0}));
  const auto last = nearest_quaternion_scalar_last(to<Body>, from<Gcrf>, 0.0, 4.0, 0.0, 3.0);
  EXPECT_EQ(last.quaternion.scalar_first(), first.quaternion.scalar_first());
}

template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
static_assert(Multiplies<Quaternion<Camera, Body>, Quaternion<Body, Gcrf>>);
static_assert(!Multiplies<Quaternion<Camera, Body>, Quaternion<Gcrf, Body>>);
static_assert(!Multiplies<Quaternion<Camera, Body>, Dcm<Body, Gcrf>>);
static_assert(Multiplies<Quaternion<Body, Gcrf>, Vector<Gcrf, si::force>>);
static_assert(!Multiplies<Quaternion<Gcrf, Body>, Vector<Gcrf, si::force>>);
static_assert(!std::is_constructible_v<Quaternion<Body, Gcrf>, double, double, double, double>);
static_assert(!std::is_convertible_v<Eigen::Quaterniond, Quaternion<Body, Gcrf>>);
static_assert(!std::is_convertible_v<Quaternion<Body, Gcrf>, Dcm<Body, Gcrf>>);
static_assert(!std::is_default_constructible_v<Quaternion<Body, Gcrf>>);

TEST(Quaternion, TheProjectionOfTinyAndHugeNumbersIsAUnitQuaternion) {
  for (const double size : {5e-324, 1e-200, 1e200, 8e307}) {
    const auto q = nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, size, size, size, size).quaternion;
    for (const double component : q.scalar_first()) EXPECT_EQ(component, 0.5) << size;
  }
  EXPECT_TRUE(contains(message<BadInput>([] {
                         nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, 1e308, 1e308, 1e308, 1e308);
                       }),
                       "the norm is inf; the numbers are too large"));
}

}  // namespace
}  // namespace quaternion_test
