#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>

#include "observed_attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace mean_rotation_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Rotations = std::vector<WeightedRotation<Body, Gcrf>>;

/// Rotations within one radian of each other have an agreement of at least a half. Each adds one rounding.
constexpr double averaged = 64 * epsilon;

Quaternion<Body, Gcrf> typed(const Quaterniond& q) {
  return nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, q.w(), q.x(), q.y(), q.z()).quaternion;
}
Quaterniond turn(const Vector3d& theta) {
  return theta.norm() > 0.0 ? Quaterniond(Eigen::AngleAxisd(theta.norm(), theta.normalized()))
                            : Quaterniond::Identity();
}
MeanRotation<Body, Gcrf> mean(const Rotations& list) {
  return mean_rotation(to<Body>, from<Gcrf>, list);
}
/// Rotations near a random attitude.
Rotations rotations() {
  const Quaterniond q = *attitude();
  Rotations list;
  for (int i = 0; i < 5; ++i)
    list.push_back(weighted(typed(q * turn(0.3 * *triple())), 1.0 + 0.5 * *coordinate()));
  return list;
}

// The dominant eigenvector of sum w q q^T, by Eigen: Markley's own form, with the quaternions' signs as
// given.
RC_GTEST_PROP(MeanRotation, IsTheDominantEigenvectorOfTheQuaternions, ()) {
  const Quaterniond q = *attitude();
  Rotations list;
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 5; ++i) {
    Quaterniond one = q * turn(0.3 * *triple());
    if (*rc::gen::arbitrary<bool>()) one.coeffs() *= -1;
    const double weight = 1.0 + 0.5 * *coordinate();
    M += weight * one.coeffs() * one.coeffs().transpose();
    list.push_back(weighted(typed(one), weight));
  }
  const Quaterniond expected(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(M).eigenvectors().col(3).eval());
  RC_ASSERT(distance(mean(list).rotation.matrix(), expected.toRotationMatrix()) <= averaged);
}

// mean(Q R_i) = Q mean(R_i), mean(R_i Q) = mean(R_i) Q, and the mean of inverses is the inverse.
RC_GTEST_PROP(MeanRotation, AChangeOfEitherFrameTurnsTheMean, ()) {
  const Rotations list = rotations();
  const Matrix3d Q = *rotation_matrix();
  const auto changed = [&](const Matrix3d& left, const Matrix3d& right) {
    Rotations others;
    for (const auto& one : list)
      others.push_back(
          weighted(trust_dcm(to<Body>, from<Gcrf>, left * one.rotation.matrix() * right), one.weight));
    return mean(others);
  };
  const Matrix3d I = Matrix3d::Identity();
  const auto plain = mean(list), turned = changed(Q, I);
  RC_ASSERT(distance(turned.rotation.matrix(), Q * plain.rotation.matrix()) <= averaged);
  RC_ASSERT(distance(turned.scatter.matrix(), Q * plain.scatter.matrix() * Q.transpose()) <= averaged);
  RC_ASSERT(distance(changed(I, Q).rotation.matrix(), plain.rotation.matrix() * Q) <= averaged);
  std::vector<WeightedRotation<Gcrf, Body>> inverses;
  for (const auto& one : list) inverses.push_back(weighted(inverse(one.rotation), one.weight));
  RC_ASSERT(distance(mean_rotation(to<Gcrf>, from<Body>, inverses).rotation.matrix(),
                     plain.rotation.matrix().transpose()) <= averaged);
}

TEST(MeanRotation, OfTwoIsHalfWayAndByWeight) {
  const auto at = [](double angle) { return turned_z(to<Body>, from<Gcrf>, rad(angle)); };
  EXPECT_LE(distance(mean_rotation(to<Body>, from<Gcrf>, std::vector{at(0.2), at(1.0)}).rotation.matrix(),
                     at(0.6).matrix()),
            rounding);
  // For rotations about one axis it is the angle of the weighted sum of the directions.
  const double angle = std::atan2(3 * std::sin(0.2) + std::sin(1.0), 3 * std::cos(0.2) + std::cos(1.0));
  const auto found = mean({weighted(at(0.2), 3.0), weighted(at(1.0), 1.0)});
  EXPECT_LE(distance(found.rotation.matrix(), at(angle).matrix()), rounding);
  const double scatter = (3 * std::pow(angle - 0.2, 2) + std::pow(1.0 - angle, 2)) / 4;
  EXPECT_LE(distance(found.scatter.matrix(), Matrix3d(Vector3d(0, 0, scatter).asDiagonal())), rounding);
}

TEST(MeanRotation, TheSignsOfQuaternionsDoNotMatter) {
  const Quaterniond p = turn({0.1, 0.2, 0.3}), q = turn({-0.2, 0.1, 0.5});
  const auto plain = mean_rotation(to<Body>, from<Gcrf>, std::vector{typed(p), typed(q)});
  const auto flipped =
      mean_rotation(to<Body>, from<Gcrf>, std::vector{typed(p), typed(Quaterniond(-q.coeffs()))});
  EXPECT_EQ(plain.rotation.matrix(), flipped.rotation.matrix());
}

TEST(MeanRotation, OfOneIsItself) {
  const auto R = body_from_gcrf(turn({1.0, -2.0, 0.5}));
  const auto found = mean_rotation(to<Body>, from<Gcrf>, std::vector{R});
  EXPECT_LE(distance(found.rotation.matrix(), R.matrix()), rounding);
  EXPECT_NEAR(found.agreement, 1.0, rounding);
}

// The scatter of many rotations is their covariance: a chi-square test of its trace, with different errors
// along the axes.
TEST(MeanRotation, TheScatterIsTheCovariance) {
  Noise noise(20240604);
  const Vector3d sigma(1e-3, 4e-3, 2e-3);
  const Quaterniond q = turn({0.4, -0.8, 1.9});
  Rotations list;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i)
    list.push_back(weighted(typed(turn(sigma.cwiseProduct(noise.column(1.0))) * q), 1.0));
  const auto found = mean(list);
  const Matrix3d normal =
      sigma.cwiseInverse().asDiagonal() * found.scatter.matrix() * sigma.cwiseInverse().asDiagonal();
  // Five standard deviations of an estimated variance, sqrt(2/n), and of a covariance, which is smaller.
  EXPECT_LE(distance(normal, Matrix3d::Identity()), 5 * std::sqrt(2.0 / count));
  // The mean itself is within five of its own standard deviations.
  const Vector3d e =
      log(found.rotation * inverse(trust_dcm(to<Camera>, from<Gcrf>, q.toRotationMatrix()))).coordinates();
  EXPECT_LE(e.cwiseQuotient(sigma).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 5 / std::sqrt(count));
}

TEST(MeanRotation, WhatHasNoMeanIsRefused) {
  const std::string place = detail::dcm_door<Body, Gcrf>("mean_rotation");
  const auto R = body_from_gcrf(turn({0.3, 0.1, -0.7}));
  const auto at = [&](double angle) {
    return trust_dcm(to<Body>, from<Gcrf>,
                     Matrix3d(R.matrix() * Eigen::AngleAxisd(angle, Vector3d(0.6, 0.0, 0.8)).matrix()));
  };
  const auto said = [](const std::vector<Dcm<Body, Gcrf>>& list) {
    return message<BadInput>([&] { mean_rotation(to<Body>, from<Gcrf>, list); });
  };
  EXPECT_EQ(said({}), place + "the number of rotations is 0");
  const std::string half = said({at(0), at(std::numbers::pi)});
  EXPECT_TRUE(contains(half, place + "the rotations have no mean: their agreement is ")) << half;
  EXPECT_TRUE(contains(said({at(0), at(2 * std::numbers::pi / 3), at(4 * std::numbers::pi / 3)}), "no mean"));
  // 0.02 is what is left of the agreement, the cosine of half the turn.
  const auto far_apart = mean_rotation(to<Body>, from<Gcrf>, std::vector{at(0), at(3.1)});
  EXPECT_LE(distance(far_apart.rotation.matrix(), at(1.55).matrix()), rounding / 0.02);
  const std::string weighted_door = detail::dcm_door<Body, Gcrf>("weighted");
  for (const double weight : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const std::string text = "the weight is " + detail::text(weight) + "; it is positive and finite";
    EXPECT_EQ(message<BadInput>([&] { weighted(R, weight); }), weighted_door + text);
    EXPECT_EQ(message<BadInput>([&] { mean({{R, weight}}); }), place + text);
  }
}

template <class To, class From, class List>
concept Averages = requires(const To& b, const From& a, const List& list) {
  mean_rotation(b, a, list);
};
static_assert(Averages<vectrix::To<Body>, vectrix::From<Gcrf>, Rotations>);
static_assert(!Averages<vectrix::To<Gcrf>, vectrix::From<Body>, Rotations>);

}  // namespace
}  // namespace mean_rotation_test
