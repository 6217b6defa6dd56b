#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/dcm_doors.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace dcm_test {
namespace {

using Length = Vector<Gcrf, si::length>;

template <class B, class A> Dcm<B, A> any_dcm() {
  return trust_dcm(to<B>, from<A>, *rotation_matrix());
}
template <class F> Vector<F, si::length> any_position() {
  return vector<si::length>(in<F>, *triple());
}

const auto generic_1 =
    trust_dcm(to<Body>, from<Gcrf>, Eigen::Quaterniond(0.5, 0.5, -0.1, 0.7).normalized().toRotationMatrix());
const auto generic_2 = trust_dcm(to<Camera>, from<Body>,
                                 Eigen::Quaterniond(0.2, -0.4, 0.8, 0.3).normalized().toRotationMatrix());

// 1. r^b = R_a^b r^a. Column i of R_a^b is the i-th basis vector of a in b.
RC_GTEST_PROP(Dcm, Law1TakesCoordinatesInAToCoordinatesInB, ()) {
  const auto R_b_from_a = any_dcm<Body, Gcrf>();
  const auto r_a = any_position<Gcrf>();
  const auto x_b = R_b_from_a * unit_x(in<Gcrf>);
  const auto y_b = R_b_from_a * unit_y(in<Gcrf>);
  const auto z_b = R_b_from_a * unit_z(in<Gcrf>);
  RC_ASSERT(x_b.coordinates() == R_b_from_a.matrix().col(0));
  const auto sum_b = r_a.x() * x_b + r_a.y() * y_b + r_a.z() * z_b;
  RC_ASSERT(distance((R_b_from_a * r_a).coordinates(), sum_b.coordinates()) <= rounding);
}

// 2. R_a^c = R_b^c R_a^b: (R1 R2) v = R1 (R2 v).
RC_GTEST_PROP(Dcm, Law2InnerFramesCancel, ()) {
  const auto R_c_from_b = any_dcm<Camera, Body>();
  const auto R_b_from_a = any_dcm<Body, Gcrf>();
  const auto r_a = any_position<Gcrf>();
  const Vector<Camera, si::length> once = (R_c_from_b * R_b_from_a) * r_a;
  const Vector<Camera, si::length> twice = R_c_from_b * (R_b_from_a * r_a);
  RC_ASSERT(distance(once.coordinates(), twice.coordinates()) <= rounding);
}

TEST(Dcm, Law2IsNotTheReversedProduct) {
  const Eigen::Matrix3d product = (generic_2 * generic_1).matrix();
  EXPECT_LE(distance(product, generic_2.matrix() * generic_1.matrix()), rounding);
  EXPECT_GT(distance(product, generic_1.matrix() * generic_2.matrix()), visible);
  EXPECT_GT(distance(product, product.transpose()), visible);
}

// 3. R_b^a = (R_a^b)^-1 = (R_a^b)^T.
RC_GTEST_PROP(Dcm, Law3TheInverseIsTheTranspose, ()) {
  const auto R_b_from_a = any_dcm<Body, Gcrf>();
  const Dcm<Gcrf, Body> R_a_from_b = inverse(R_b_from_a);
  RC_ASSERT(R_a_from_b.matrix() == R_b_from_a.matrix().transpose());
  RC_ASSERT(distance((R_a_from_b * R_b_from_a).matrix(), Eigen::Matrix3d::Identity()) <= rounding);
  const auto r_a = any_position<Gcrf>();
  RC_ASSERT(distance((R_a_from_b * (R_b_from_a * r_a)).coordinates(), r_a.coordinates()) <= rounding);
}

RC_GTEST_PROP(Dcm, InverseOfAProductReversesIt, ()) {
  const auto R_c_from_b = any_dcm<Camera, Body>();
  const auto R_b_from_a = any_dcm<Body, Gcrf>();
  RC_ASSERT(distance(inverse(R_c_from_b * R_b_from_a).matrix(),
                     (inverse(R_b_from_a) * inverse(R_c_from_b)).matrix()) <= rounding);
}

// rotate(): turning a onto b takes a's axes to b's axes, all expressed in a.
RC_GTEST_PROP(Dcm, RotateTurnsTheAxesOfAOntoThoseOfB, ()) {
  const auto R_a_from_b = any_dcm<Gcrf, Body>();
  const Vector<Gcrf, si::dimensionless> turned = rotate(R_a_from_b, unit_y(in<Gcrf>));
  RC_ASSERT(turned.coordinates() == (R_a_from_b * unit_y(in<Body>)).coordinates());
}

TEST(Dcm, APlainTurnAboutZHasItsPublishedMatrix) {
  const auto quarter = convert<si::angle>(90.0 * si::degree);
  const Dcm<Body, Gcrf> R_b_from_a = turned_z(to<Body>, from<Gcrf>, quarter);
  Eigen::Matrix3d expected;
  expected << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  EXPECT_LE(distance(R_b_from_a.matrix(), expected), epsilon);
  // b's x axis is along a's y axis; a's x axis is along b's -y axis; the active rotation takes x to y.
  EXPECT_LE(distance((inverse(R_b_from_a) * unit_x(in<Body>)).coordinates(), Eigen::Vector3d::UnitY()),
            epsilon);
  EXPECT_LE(distance((R_b_from_a * unit_x(in<Gcrf>)).coordinates(), -Eigen::Vector3d::UnitY()), epsilon);
  EXPECT_LE(distance(rotate(inverse(R_b_from_a), unit_x(in<Gcrf>)).coordinates(), Eigen::Vector3d::UnitY()),
            epsilon);
}

// If turning a by (theta, n) gives b, Eigen's AngleAxis matrix is R_a_from_b, not R_b_from_a.
TEST(Dcm, EigensAngleAxisMatrixIsTheRotationFromTheTurnedFrame) {
  const double theta = 0.7;
  const auto angle = theta * si::radian;
  const auto eigen = [&](const Eigen::Vector3d& n) { return Eigen::AngleAxisd(theta, n).toRotationMatrix(); };
  EXPECT_LE(
      distance(inverse(turned_x(to<Body>, from<Gcrf>, angle)).matrix(), eigen(Eigen::Vector3d::UnitX())),
      rounding);
  EXPECT_LE(
      distance(inverse(turned_y(to<Body>, from<Gcrf>, angle)).matrix(), eigen(Eigen::Vector3d::UnitY())),
      rounding);
  EXPECT_LE(
      distance(inverse(turned_z(to<Body>, from<Gcrf>, angle)).matrix(), eigen(Eigen::Vector3d::UnitZ())),
      rounding);
  EXPECT_GT(distance(turned_z(to<Body>, from<Gcrf>, angle).matrix(), eigen(Eigen::Vector3d::UnitZ())),
            visible);
}

// The rule that the inner frames cancel, checked by overload resolution.
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class R, class V>
concept Rotates = requires(const R& rotation, const V& vector) {
  rotate(rotation, vector);
};

static_assert(Multiplies<Dcm<Camera, Body>, Dcm<Body, Gcrf>>);
static_assert(!Multiplies<Dcm<Camera, Body>, Dcm<Gcrf, Body>>);
static_assert(!Multiplies<Dcm<Body, Gcrf>, Dcm<Camera, Body>>);
static_assert(!Multiplies<Dcm<Body, Wheel<2>>, Dcm<Wheel<1>, Body>>);
static_assert(Multiplies<Dcm<Body, Gcrf>, Length>);
static_assert(!Multiplies<Dcm<Gcrf, Body>, Length>);
static_assert(!Multiplies<Length, Dcm<Gcrf, Body>>);
static_assert(Rotates<Dcm<Gcrf, Body>, Length>);
static_assert(!Rotates<Dcm<Body, Gcrf>, Length>);
static_assert(!std::is_convertible_v<Dcm<Gcrf, Body>, Dcm<Body, Gcrf>>);
static_assert(!std::is_convertible_v<Eigen::Matrix3d, Dcm<Body, Gcrf>>);
static_assert(!std::is_default_constructible_v<Dcm<Body, Gcrf>>);
static_assert(sizeof(Dcm<Body, Gcrf>) == 9 * sizeof(double));

}  // namespace
}  // namespace dcm_test
