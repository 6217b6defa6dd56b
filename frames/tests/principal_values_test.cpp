#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vectrix/frames/scalar/principal_values.hpp>

using namespace vectrix;

namespace principal_values_test {
namespace {

using detail::principal_values;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Both solvers turn the matrix up to two dozen times, each time with a few roundings of its largest value.
constexpr double rounding = 1e-14;

Matrix3d turned(const Matrix3d& R, const Vector3d& values) {
  const Matrix3d product = R * values.asDiagonal() * R.transpose();
  return (product + product.transpose()) / 2.0;
}

TEST(PrincipalValues, AreThoseOfEigensSolverInAnyAxes) {
  std::mt19937_64 generator(2);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 500; ++trial) {
    const auto any = [&] { return normal(generator); };
    const Matrix3d R = Eigen::Quaterniond(any(), any(), any(), any()).normalized().matrix();
    // Apart by up to twelve decades; two or three of them may be equal.
    Vector3d values = Vector3d::NullaryExpr([&] { return any() * std::pow(10.0, -4.0 * std::abs(any())); });
    if (trial % 3 == 1) values[1] = values[0];
    if (trial % 9 == 1) values[2] = values[0];
    const Matrix3d A = turned(R, values);
    const Vector3d expected =
        Eigen::SelfAdjointEigenSolver<Matrix3d>(A, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_LE((principal_values(A) - expected).cwiseAbs().maxCoeff(), rounding * A.norm()) << A;
  }
}

TEST(PrincipalValues, OfADiagonalMatrixAreItsNumbersInIncreasingOrder) {
  EXPECT_EQ(principal_values(Matrix3d(Vector3d(4.0, -1.0, 2.0).asDiagonal())), Vector3d(-1.0, 2.0, 4.0));
  EXPECT_EQ(principal_values(Matrix3d(Matrix3d::Zero())), Vector3d(Vector3d::Zero()));
}

TEST(PrincipalValues, ScaleWithNumbersWhoseSquaresOverflowOrUnderflow) {
  // [2 1 0; 1 2 0; 0 0 1] has 1, 1, 3.
  Matrix3d A;
  A << 2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 1.0;
  for (const double scale : {1e-300, 1.0, 1e307}) {
    const Vector3d values = principal_values(Matrix3d(scale * A)) / scale;
    EXPECT_LE((values - Vector3d(1.0, 1.0, 3.0)).cwiseAbs().maxCoeff(), rounding) << scale;
  }
}

TEST(PrincipalValues, AreReadFromTheLowerHalf) {
  Matrix3d A = Matrix3d::Identity();
  A(1, 0) = 0.5;  // of [1 1/2; 1/2 1]: 1/2 and 3/2
  A(0, 1) = 7.0;
  EXPECT_LE((principal_values(A) - Vector3d(0.5, 1.0, 1.5)).cwiseAbs().maxCoeff(), 7.0 * rounding);
}

}  // namespace
}  // namespace principal_values_test
