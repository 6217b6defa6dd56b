#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <vectrix/frames/covariance.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace covariance_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using PositionCovariance = Covariance<Body, si::length>;

/// Sums of six squares of numbers of order 1, with a change of axes.
constexpr double sum_rounding = 64 * epsilon;
/// Added to variances of at most 1, so that P can be inverted: its condition number is at most 300.
constexpr double least_variance = 1e-2;
constexpr double solved = 1e4 * epsilon;

/// The covariance of equally likely vectors, by its definition: the reference for the tests.
Matrix3d covariance_of(const std::vector<Vector3d>& samples) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& r : samples) mean += r / static_cast<double>(samples.size());
  Matrix3d P = Matrix3d::Zero();
  for (const Vector3d& r : samples)
    P += (r - mean) * (r - mean).transpose() / static_cast<double>(samples.size());
  return P;
}

rc::Gen<std::vector<Vector3d>> samples() {
  return rc::gen::container<std::vector<Vector3d>>(6, triple());
}

PositionCovariance generic() {
  Matrix3d P;
  P << 4.0, 0.5, -0.3, 0.5, 9.0, 0.7, -0.3, 0.7, 1.0;
  return covariance<si::length>(in<Body>, P);
}

// 1. P^b = R_a^b P^a (R_a^b)^T: the covariance of the vectors R_a^b r^a.
RC_GTEST_PROP(Covariance, Law1ChangeOfAxes, ()) {
  const auto r_a = *samples();
  const Matrix3d R = *rotation_matrix();
  std::vector<Vector3d> r_b;
  for (const Vector3d& r : r_a) r_b.emplace_back(R * r);
  const auto P_a = covariance<si::length>(in<Body>, covariance_of(r_a));
  const Covariance<Camera, si::length> P_b = trust_dcm(to<Camera>, from<Body>, R) * P_a;
  RC_ASSERT(distance(P_b.matrix(), covariance_of(r_b)) < sum_rounding);
}

TEST(Covariance, Law1IsNotTheOtherWayRound) {
  const Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -2.0).normalized()).matrix();
  const auto P_b = trust_dcm(to<Camera>, from<Body>, R) * generic();
  EXPECT_GT(distance(P_b.matrix(), R.transpose() * generic().matrix() * R), visible);
}

// 1, chained: R_c^d (R_a^c P^a) = (R_c^d R_a^c) P^a.
RC_GTEST_PROP(Covariance, Law1Chains, ()) {
  const auto P = covariance<si::length>(in<Body>, covariance_of(*samples()));
  const auto R_c_from_b = trust_dcm(to<Camera>, from<Body>, *rotation_matrix());
  const auto R_g_from_c = trust_dcm(to<Ground>, from<Camera>, *rotation_matrix());
  RC_ASSERT(distance((R_g_from_c * (R_c_from_b * P)).matrix(), ((R_g_from_c * R_c_from_b) * P).matrix()) <
            sum_rounding);
}

// 2. cov(r + s) = cov(r) + cov(s): every r is paired with every s, so that they are independent.
RC_GTEST_PROP(Covariance, Law2IndependentOnesAdd, ()) {
  const auto r_a = *samples();
  const auto s_a = *samples();
  std::vector<Vector3d> sums;
  for (const Vector3d& r : r_a) {
    for (const Vector3d& s : s_a) sums.emplace_back(r + s);
  }
  const PositionCovariance P = covariance<si::length>(in<Body>, covariance_of(r_a)) +
                               covariance<si::length>(in<Body>, covariance_of(s_a));
  RC_ASSERT(distance(P.matrix(), covariance_of(sums)) < sum_rounding);
}

// 3. var(n . r) = n^T P n, in square metres.
RC_GTEST_PROP(Covariance, Law3VarianceOfAComponent, ()) {
  const auto r_a = *samples();
  const Vector3d n = (*rotation_matrix()).col(0);
  double mean = 0.0, square = 0.0;
  for (const Vector3d& r : r_a) {
    mean += n.dot(r) / 6.0;
    square += n.dot(r) * n.dot(r) / 6.0;
  }
  const Quantity<si::area> variance = variance_along(covariance<si::length>(in<Body>, covariance_of(r_a)),
                                                     vector<si::dimensionless>(in<Body>, n));
  RC_ASSERT(std::abs(variance.value() - (square - mean * mean)) < sum_rounding);
}

TEST(Covariance, StandardDeviationsAreSquaredOnTheirAxes) {
  const auto P =
      covariance_from_standard_deviations(in<Body>, 2.0 * si::metre, 0.0 * si::metre, 3.0 * si::metre);
  static_assert(std::same_as<decltype(P), const PositionCovariance>);
  EXPECT_EQ(P.matrix(), Matrix3d(Vector3d(4.0, 0.0, 9.0).asDiagonal()));
}

TEST(MahalanobisDistance, CountsStandardDeviations) {
  const auto P =
      covariance_from_standard_deviations(in<Body>, 2.0 * si::metre, 1.0 * si::metre, 4.0 * si::metre);
  const auto r = vector(in<Body>, 4.0 * si::metre, -3.0 * si::metre, 24.0 * si::metre);
  const Quantity<si::dimensionless> d = mahalanobis_distance(P, r);  // of (2, -3, 6)
  EXPECT_NEAR(d.value(), 7.0, 8 * epsilon);
  const auto R = trust_dcm(to<Camera>, from<Body>,
                           Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -2.0).normalized()).matrix());
  EXPECT_NEAR(mahalanobis_distance(R * P, R * r).value(), 7.0, 1e3 * epsilon);  // condition 16, and rotations
}

RC_GTEST_PROP(MahalanobisDistance, IsThatOfTheInverse, ()) {
  const Matrix3d P = covariance_of(*samples()) + least_variance * Matrix3d::Identity();
  const Vector3d r = *triple();
  const double expected = std::sqrt(r.dot(P.inverse() * r));
  const double found =
      mahalanobis_distance(covariance<si::length>(in<Body>, P), vector<si::length>(in<Body>, r)).value();
  RC_ASSERT(std::abs(found - expected) <= solved * expected);
}

TEST(MahalanobisDistance, TakesAxesOfVeryDifferentSize) {
  const auto P =
      covariance_from_standard_deviations(in<Body>, 1e-9 * si::metre, 1.0 * si::metre, 1e9 * si::metre);
  const auto r = vector(in<Body>, 2e-9 * si::metre, 3.0 * si::metre, 6e9 * si::metre);
  EXPECT_NEAR(mahalanobis_distance(P, r).value(), 7.0, 16 * epsilon);
}

TEST(MahalanobisDistance, RefusesASingularCovariance) {
  const auto r = vector(in<Body>, 1.0 * si::metre, 1.0 * si::metre, 1.0 * si::metre);
  const auto flat =
      covariance_from_standard_deviations(in<Body>, 1.0 * si::metre, 0.0 * si::metre, 1.0 * si::metre);
  const auto said = [&](const PositionCovariance& P) {
    return message<BadInput>([&] { mahalanobis_distance(P, r); });
  };
  EXPECT_TRUE(contains(said(flat), "mahalanobis_distance(covariance in " + frame_name<Body>()));
  EXPECT_TRUE(contains(said(flat), "the other axes leave open is 0"));
  // Flat, in a plane that contains none of the axes.
  const Vector3d n = Vector3d(1.0, 2.0, 2.0) / 3.0;
  const Matrix3d oblique = Matrix3d::Identity() - n * n.transpose();
  EXPECT_TRUE(contains(said(covariance<si::length>(in<Body>, oblique)), "is singular"));
}

TEST(Covariance, WhatIsNoneIsRefused) {
  const auto said = [](const Matrix3d& P) {
    return message<BadInput>([&] { covariance<si::length>(in<Body>, P); });
  };
  const std::string place = "covariance(in<" + frame_name<Body>() + ">): ";
  Matrix3d P = generic().matrix();
  P(1, 2) = std::nan("");
  EXPECT_EQ(said(P), place + "entry (2, 3) is nan");
  P(1, 2) = HUGE_VAL;
  EXPECT_EQ(said(P), place + "entry (2, 3) is inf");
  P(1, 2) = 0.75;
  EXPECT_TRUE(contains(said(P), "is not symmetric: it differs from its transpose by 0.05"));
  EXPECT_TRUE(contains(said(Vector3d(4.0, -1.0, 9.0).asDiagonal()), "the principal variances (-1, 4, 9)"));
  P << 1.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0;  // a correlation of 2
  EXPECT_TRUE(contains(said(P), "are not all positive or zero"));
  EXPECT_TRUE(contains(said(-Matrix3d::Identity()), "are not all positive or zero"));
  EXPECT_EQ(said(Matrix3d::Zero()), "");
}

// Relative to the largest entry, and to the largest variance, at every size.
TEST(Covariance, ItsTolerancesHoldOnBothSides) {
  const auto said = [](const Matrix3d& P) {
    return message<BadInput>([&] { covariance<si::length>(in<Body>, P); });
  };
  for (const double size : {1e-20, 1.0, 1e20}) {
    for (int least = 0; least < 3; ++least) {
      Vector3d variances(2.0 * size, 9.0 * size, 2.0 * size);
      variances(least) = 0.0;
      const double bound = covariance_tolerance * variances.maxCoeff();
      variances(least) = -0.999 * bound;
      EXPECT_EQ(said(variances.asDiagonal()), "") << size;
      variances(least) = -1.001 * bound;
      EXPECT_TRUE(contains(said(variances.asDiagonal()), "are not all positive or zero")) << size;
    }
    for (const double sign : {-1.0, 1.0}) {
      Matrix3d P = size * generic().matrix();
      const double bound = sign * covariance_tolerance * 9.0 * size;
      P(0, 1) += 0.99 * bound;  // the rounding of an entry is 1e-4 of the bound
      EXPECT_EQ(said(P), "") << size;
      P(0, 1) += 0.02 * bound;
      EXPECT_TRUE(contains(said(P), "is not symmetric")) << size;
    }
  }
}

TEST(Covariance, ADirectionIsOneToItsTolerance) {
  const auto said = [](double length) {
    return message<BadInput>([&] { variance_along(generic(), length * unit_x(in<Body>)); });
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(said(1.0 + sign * 0.999 * orthonormality_tolerance), "");
    EXPECT_NE(said(1.0 + sign * 1.001 * orthonormality_tolerance), "");
  }
}

// The share of a variance that the other axes leave open, of a correlation r, is 1 - r^2.
TEST(MahalanobisDistance, RefusesAShareBelowItsTolerance) {
  const auto r = vector(in<Body>, 1.0 * si::metre, 1.0 * si::metre, 1.0 * si::metre);
  const auto said = [&](double share) {
    Matrix3d P = Matrix3d::Identity();
    P(0, 1) = P(1, 0) = std::sqrt(1.0 - share);
    return message<BadInput>([&] { mahalanobis_distance(covariance<si::length>(in<Body>, P), r); });
  };
  EXPECT_EQ(said(1.01 * covariance_tolerance), "");
  EXPECT_TRUE(contains(said(0.99 * covariance_tolerance), "the covariance is singular"));
}

TEST(Covariance, WhatIsNoDeviationOrDirectionIsRefused) {
  const auto said = [](double x) {
    return message<BadInput>([&] {
      covariance_from_standard_deviations(in<Body>, 1.0 * si::metre, x * si::metre, 1.0 * si::metre);
    });
  };
  for (const double x : {-1.0, std::nan(""), HUGE_VAL, 1e200, 1e-200}) {
    EXPECT_TRUE(contains(said(x), "(1, " + detail::text(x) + ", 1) are not all zero, or positive")) << x;
  }
  const auto twice = 2.0 * unit_x(in<Body>);
  EXPECT_TRUE(contains(message<BadInput>([&] { variance_along(generic(), twice); }), "|n| is 2"));
}

TEST(Covariance, TheTrustedDoorTakesWhatIsNone) {
  EXPECT_EQ(trust_covariance<si::length>(in<Body>, -Matrix3d::Identity()).matrix(), -Matrix3d::Identity());
}

TEST(Covariance, SaysItsUnitAndFrame) {
  const auto printed = [](const auto& P) {
    std::ostringstream out;
    out << P;
    return out.str();
  };
  const std::string entries = "[1 0 0; 0 4 0; 0 0 9] ", body = "in " + frame_name<Body>();
  const Matrix3d P = Vector3d(1.0, 4.0, 9.0).asDiagonal();
  EXPECT_EQ(printed(covariance<si::length>(in<Body>, P)), entries + "m^2 " + body);
  EXPECT_EQ(printed(covariance<si::velocity>(in<Body>, P)), entries + "(m/s)^2 " + body);
  EXPECT_EQ(printed(covariance<si::dimensionless>(in<Body>, P)), entries + body);
}

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class T>
concept Negates = requires(const T& value) {
  -value;
};
template <class Left, class Right>
concept Subtracts = requires(const Left& left, const Right& right) {
  left - right;
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class P, class R>
concept Measures = requires(const P& p, const R& r) {
  mahalanobis_distance(p, r);
};
static_assert(Adds<PositionCovariance, PositionCovariance>);
static_assert(!Adds<PositionCovariance, Covariance<Camera, si::length>>);
static_assert(!Adds<PositionCovariance, Covariance<Body, si::velocity>>);
static_assert(!Subtracts<PositionCovariance, PositionCovariance> && !Negates<PositionCovariance>);
static_assert(Multiplies<Dcm<Camera, Body>, PositionCovariance>);
static_assert(!Multiplies<Dcm<Body, Camera>, PositionCovariance>);
static_assert(!Multiplies<PositionCovariance, Dcm<Body, Camera>>);
static_assert(Measures<PositionCovariance, Vector<Body, si::length>>);
static_assert(!Measures<PositionCovariance, Vector<Camera, si::length>>);
static_assert(!Measures<PositionCovariance, Vector<Body, si::velocity>>);
static_assert(!std::is_default_constructible_v<PositionCovariance>);
static_assert(!std::is_constructible_v<PositionCovariance, Matrix3d>);
static_assert(sizeof(PositionCovariance) == sizeof(Matrix3d));

}  // namespace
}  // namespace covariance_test
