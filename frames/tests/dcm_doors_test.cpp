#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <vectrix/frames/dcm_doors.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace dcm_doors_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refused(const Eigen::Matrix3d& matrix) {
  return message<BadInput>([&] { dcm(to<Body>, from<Gcrf>, matrix); });
}
std::string not_projected(const Eigen::Matrix3d& matrix) {
  return message<BadInput>([&] { nearest_dcm(to<Body>, from<Gcrf>, matrix); });
}

RC_GTEST_PROP(DcmDoors, TheCheckedDoorKeepsEveryRotationAsItIs, ()) {
  const Eigen::Matrix3d matrix = *rotation_matrix();
  RC_ASSERT(dcm(to<Body>, from<Gcrf>, matrix).matrix() == matrix);
}

TEST(DcmDoors, TheErrorNamesTheDoorTheFramesAndTheNumber) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(1, 2) = nan;
  const std::string text = refused(matrix);
  EXPECT_TRUE(contains(text, "dcm(to<")) << text;
  EXPECT_TRUE(contains(text, "Body>, from<")) << text;
  EXPECT_TRUE(contains(text, "Gcrf>): entry (2, 3) is nan")) << text;
}

TEST(DcmDoors, TakeABlockOfALargerMatrix) {
  Eigen::MatrixXd adjoint = Eigen::MatrixXd::Identity(6, 6);
  const Eigen::Index three = 3, four = 4;
  EXPECT_EQ(dcm(to<Body>, from<Gcrf>, adjoint.block(three, three, three, three)).matrix(),
            Eigen::Matrix3d::Identity());
  const std::string size = "the matrix has 3 x 4 entries, not 3 x 3";
  const auto block = adjoint.block(0, 0, three, four);
  EXPECT_TRUE(contains(message<BadInput>([&] { dcm(to<Body>, from<Gcrf>, block); }), size));
  EXPECT_TRUE(contains(message<BadInput>([&] { nearest_dcm(to<Body>, from<Gcrf>, block); }), size));
  EXPECT_TRUE(contains(message<BadInput>([&] { trust_dcm(to<Body>, from<Gcrf>, block); }), size));
}

TEST(DcmDoors, InfinityIsBadInput) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(2, 0) = -infinity;
  EXPECT_TRUE(contains(refused(matrix), "entry (3, 1) is -inf"));
  EXPECT_TRUE(contains(not_projected(matrix), "nearest_dcm(to<"));
  EXPECT_TRUE(contains(not_projected(matrix), "entry (3, 1) is -inf"));
}

TEST(DcmDoors, EveryEntryIsChecked) {
  for (int i = 0; i < 9; ++i) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
    matrix(i) = nan;
    EXPECT_TRUE(contains(refused(matrix), "is nan")) << i;
  }
}

TEST(DcmDoors, ANumberTooManyIsNotOrthonormal) {
  const Eigen::Matrix3d rounded = 1.25 * Eigen::Matrix3d::Identity();
  const std::string text = refused(rounded);
  EXPECT_TRUE(contains(text, "M^T M differs from the identity by 0.5625, tolerance 1e-09")) << text;
  EXPECT_TRUE(contains(text, "nearest_dcm() projects")) << text;
  // Numbers so large that the check itself overflows.
  EXPECT_TRUE(contains(refused(1e200 * Eigen::Matrix3d::Identity()), "differs from the identity by inf"));
}

TEST(DcmDoors, TheToleranceIsThatOfTenPrintedDigits) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 1) = 0.9 * orthonormality_tolerance;
  EXPECT_EQ(refused(matrix), "");
  matrix(0, 1) = 1.1 * orthonormality_tolerance;
  EXPECT_NE(refused(matrix), "");
}

TEST(DcmDoors, TheToleranceHoldsForEveryEntryAndBothSigns) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double most = row == column ? orthonormality_tolerance / 2 : orthonormality_tolerance;
      for (const double sign : {-1.0, 1.0}) {
        Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
        matrix(row, column) += sign * 0.999 * most;
        EXPECT_EQ(refused(matrix), "") << row << column;
        matrix(row, column) += sign * 0.002 * most;
        EXPECT_NE(refused(matrix), "") << row << column;
      }
    }
  }
}

// Kept as given, factors at the tolerance make a product beyond it.
TEST(DcmDoors, ErrorsOfFactorsAddInAProduct) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  matrix(0, 1) = 0.9 * orthonormality_tolerance;
  const auto R = dcm(to<Body>, from<Gcrf>, matrix);
  EXPECT_EQ(R.matrix(), matrix);
  const Dcm<Body, Body> again = R * inverse(R);
  EXPECT_TRUE(contains(refused(again.matrix()), "nearest_dcm() projects"));
  EXPECT_NEAR(nearest_dcm(to<Body>, from<Gcrf>, again.matrix()).distance, std::sqrt(2.0) * matrix(0, 1),
              1e-3 * orthonormality_tolerance);
}

TEST(DcmDoors, AReflectionIsNoRotation) {
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
  EXPECT_TRUE(contains(refused(mirror), "the determinant is -1; a rotation is right-handed"))
      << refused(mirror);
  EXPECT_TRUE(contains(not_projected(mirror), "the determinant is -1; a rotation is right-handed"));
  EXPECT_TRUE(contains(refused(Eigen::Matrix3d::Zero()), "differs from the identity by 1"));
}

RC_GTEST_PROP(DcmDoors, TheProjectionOfAStretchedRotationIsTheRotation, ()) {
  // M = R P with P symmetric and positive: the polar factor is R, and the distance is |M - R|.
  const Eigen::Matrix3d rotation = *rotation_matrix();
  const Eigen::Vector3d stretch = Eigen::Vector3d::Constant(1.5) + *triple();
  const Eigen::Matrix3d axes = *rotation_matrix();
  const Eigen::Matrix3d stretched = rotation * axes * stretch.asDiagonal() * axes.transpose();
  const auto nearest = nearest_dcm(to<Body>, from<Gcrf>, stretched);
  // The condition of the polar factor depends on the sum of the two smallest stretches, which is at least 1
  // here.
  const double conditioned = 16 * rounding;
  RC_ASSERT(distance(nearest.dcm.matrix(), rotation) <= conditioned);
  RC_ASSERT(std::abs(nearest.distance - (stretched - rotation).norm()) <= conditioned);
}

TEST(DcmDoors, TheProjectionIsNearerThanAnyOther) {
  Eigen::Matrix3d noisy;
  noisy << 0.01, 0.98, 0.02, -1.03, 0.02, 0.01, 0.03, -0.02, 0.99;
  const auto nearest = nearest_dcm(to<Body>, from<Gcrf>, noisy);
  EXPECT_EQ(refused(nearest.dcm.matrix()), "");
  for (int axis = 0; axis < 3; ++axis) {
    for (const double angle : {-1e-3, 1e-3}) {
      const Eigen::AngleAxisd nudge(angle, Eigen::Vector3d::Unit(axis));
      EXPECT_GT((nudge.toRotationMatrix() * nearest.dcm.matrix() - noisy).norm(), nearest.distance);
    }
  }
}

TEST(DcmDoors, NoRotationIsNearestToASingularMatrix) {
  std::mt19937_64 generator(20);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::NullaryExpr([&] { return normal(generator); });
    matrix.row(2) = normal(generator) * matrix.row(0) + normal(generator) * matrix.row(1);
    EXPECT_TRUE(contains(not_projected(matrix), "singular matrix")) << matrix;
  }
  EXPECT_TRUE(contains(not_projected(Eigen::Matrix3d::Zero()), "singular matrix"));
}

// Whether a matrix is right-handed must not be rounding; a small stretch alone does no harm.
TEST(DcmDoors, ASmallDeterminantAboveTheBoundIsProjected) {
  for (const double size : {1.0, 1e-100, 1e100}) {
    const auto stretched = [&](double determinant) {
      return Eigen::Matrix3d(size * Eigen::Matrix3d(Eigen::Vector3d(1.0, determinant, 1.0).asDiagonal()));
    };
    const auto nearest = nearest_dcm(to<Body>, from<Gcrf>, stretched(1.01 * nearly_singular));
    EXPECT_EQ(nearest.dcm.matrix(), Eigen::Matrix3d::Identity());
    EXPECT_TRUE(contains(not_projected(stretched(0.99 * nearly_singular)), "singular matrix"));
    EXPECT_TRUE(contains(not_projected(stretched(-0.99 * nearly_singular)), "singular matrix"));
    EXPECT_TRUE(contains(not_projected(stretched(-1.01 * nearly_singular)), "right-handed"));
  }
}

TEST(DcmDoors, TheSizeOfTheMatrixDoesNotMatterToTheProjection) {
  for (const double size : {1e-200, 1e200}) {
    EXPECT_EQ(nearest_dcm(to<Body>, from<Gcrf>, size * Eigen::Matrix3d::Identity()).dcm.matrix(),
              Eigen::Matrix3d::Identity());
  }
}

TEST(DcmDoors, TheTrustedDoorChecksNothing) {
  EXPECT_EQ(trust_dcm(to<Body>, from<Gcrf>, Eigen::Matrix3d::Zero()).matrix(), Eigen::Matrix3d::Zero());
}

TEST(DcmDoors, AlignedFramesShareCoordinates) {
  EXPECT_EQ((aligned(to<Body>, from<Gcrf>).matrix()), Eigen::Matrix3d::Identity());
}

TEST(DcmDoors, TurnsAboutOneAxisAdd) {
  const auto part = 0.3 * si::radian;
  const auto whole = 0.6 * si::radian;
  EXPECT_LE(distance((turned_x(to<Camera>, from<Body>, part) * turned_x(to<Body>, from<Gcrf>, part)).matrix(),
                     turned_x(to<Camera>, from<Gcrf>, whole).matrix()),
            rounding);
  EXPECT_LE(distance((turned_y(to<Camera>, from<Body>, part) * turned_y(to<Body>, from<Gcrf>, part)).matrix(),
                     turned_y(to<Camera>, from<Gcrf>, whole).matrix()),
            rounding);
  EXPECT_LE(distance((turned_z(to<Camera>, from<Body>, part) * turned_z(to<Body>, from<Gcrf>, part)).matrix(),
                     turned_z(to<Camera>, from<Gcrf>, whole).matrix()),
            rounding);
}

TEST(DcmDoors, ATurnByNoNumberIsBadInput) {
  const auto text =
      message<BadInput>([] { turned_y(to<Body>, from<Gcrf>, Quantity<si::angle>::from_value(nan)); });
  EXPECT_TRUE(contains(text, "turned_y(to<")) << text;
  EXPECT_TRUE(contains(text, "the angle is nan")) << text;
  EXPECT_TRUE(contains(
      message<BadInput>([] { turned_z(to<Body>, from<Gcrf>, Quantity<si::angle>::from_value(infinity)); }),
      "the angle is inf"));
}

TEST(DcmDoors, AxesAreTheRowsOfTheMatrix) {
  // b's axes in a: x_b = y_a, y_b = z_a, z_b = x_a.
  const auto R_b_from_a = dcm_from_axes(to<Body>, unit_y(in<Gcrf>), unit_z(in<Gcrf>), unit_x(in<Gcrf>));
  EXPECT_EQ((R_b_from_a * unit_y(in<Gcrf>)).coordinates(), Eigen::Vector3d::UnitX());
  EXPECT_EQ((R_b_from_a * unit_x(in<Gcrf>)).coordinates(), Eigen::Vector3d::UnitZ());
  const auto left = message<BadInput>(
      [] { dcm_from_axes(to<Body>, unit_y(in<Gcrf>), unit_x(in<Gcrf>), unit_z(in<Gcrf>)); });
  EXPECT_TRUE(contains(left, "dcm_from_axes(to<") && contains(left, "the determinant is -1")) << left;
}

TEST(DcmDoors, FrameNamesAreThoseOfTheSource) {
  EXPECT_TRUE(contains(frame_name<Gcrf>(), "Gcrf"));
  EXPECT_TRUE(contains(frame_name<Wheel<2>>(), "Wheel<2>"));
  EXPECT_FALSE(contains(frame_name<Gcrf>(), ";"));
}

}  // namespace
}  // namespace dcm_doors_test
