#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "observed_attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace triad_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Without errors any method must return the exact rotation.
RC_GTEST_PROP(Triad, ReturnsTheRotationOfExactVectors, ()) {
  const auto [r, s] = two_directions();
  const auto R = body_from_gcrf(*attitude());
  const auto r_a = vector<si::length>(in<Gcrf>, r);
  const auto s_a = vector<si::velocity>(in<Gcrf>, s);
  const Dcm<Body, Gcrf> found = triad(to<Body>, from<Gcrf>, R * r_a, r_a, R * s_a, s_a);
  RC_ASSERT(distance(found.matrix(), R.matrix()) <= solved);
}

// The first direction is met exactly, the second one only in its half plane.
RC_GTEST_PROP(Triad, TheFirstCountsFully, ()) {
  const auto [r, s] = two_directions();
  const auto [u, v] = two_directions();
  const auto R = triad(to<Body>, from<Gcrf>, measured(u), reference(r), measured(v), reference(s));
  const Vector3d first = (R * reference(r)).coordinates(), second = (R * reference(s)).coordinates();
  RC_ASSERT(distance(first, u.normalized()) <= solved);
  RC_ASSERT(std::abs(second.dot(u.cross(v).normalized())) <= solved);
  RC_ASSERT(first.cross(second).dot(u.cross(v)) > 0.0);
  RC_ASSERT(distance(R.matrix() * R.matrix().transpose(), Matrix3d::Identity()) <= rounding);
}

TEST(Triad, ClosedForm) {
  const auto R =
      triad(to<Body>, from<Gcrf>, unit_x(in<Body>), unit_y(in<Gcrf>), unit_y(in<Body>), unit_z(in<Gcrf>));
  Matrix3d expected;
  expected << 0, 1, 0, 0, 0, 1, 1, 0, 0;
  EXPECT_EQ(R.matrix(), expected);
}

// Shuster and Oh's covariance as printed; the library computes a sum of squares.
RC_GTEST_PROP(Triad, TheCovarianceIsShustersAndOhs, ()) {
  const auto [r, s] = two_directions();
  const auto R = body_from_gcrf(*attitude());
  const double s1 = 0.01, s2 = 0.03;
  const auto found = triad(to<Body>, from<Gcrf>, seen(R, r, s1), seen(R, s, s2));
  const Vector3d b1 = R.matrix() * r.normalized(), b2 = R.matrix() * s.normalized();
  const double sine2 = b1.cross(b2).squaredNorm();
  const Matrix3d P =
      s1 * s1 * Matrix3d::Identity() + ((s2 * s2 - s1 * s1) * b1 * b1.transpose() +
                                        s1 * s1 * b1.dot(b2) * (b1 * b2.transpose() + b2 * b1.transpose())) /
                                           sine2;
  RC_ASSERT(distance(found.covariance.matrix(), P) <= solved * P.norm());
}

TEST(Triad, NearlyParallelDirectionsStillGiveARotation) {
  const auto R = body_from_gcrf(Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized());
  const Vector3d r = Vector3d(1.0, 2.0, -0.5), s = r + 1e-7 * Vector3d(0.3, -1.0, 0.7);
  const auto found =
      triad(to<Body>, from<Gcrf>, R * reference(r), reference(r), R * reference(s), reference(s));
  EXPECT_LE(distance(found.matrix() * found.matrix().transpose(), Matrix3d::Identity()), rounding);
  EXPECT_LE(distance(found.matrix(), R.matrix()), 1e-7);
}

TEST(Triad, ParallelDirectionsAreRefused) {
  const auto said = [](const Vector3d& r, const Vector3d& s, const Vector3d& u, const Vector3d& v) {
    return message<BadInput>(
        [&] { triad(to<Body>, from<Gcrf>, measured(u), reference(r), measured(v), reference(s)); });
  };
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const std::string place = detail::dcm_door<Body, Gcrf>("triad");
  const std::string which = "the sine of the angle between the two directions in ";
  EXPECT_EQ(said(x, y, x, -2 * x),
            place + which + frame_name<Body>() + " is 0; parallel directions fix no rotation");
  EXPECT_TRUE(contains(said(x, x, x, y), which + frame_name<Gcrf>() + " is 0"));
  EXPECT_TRUE(contains(said(x, x + 1e-10 * y, x, y), " is 1e-10"));
  const auto none = zero<si::dimensionless>(in<Body>);
  EXPECT_EQ(
      message<BadInput>([&] { triad(to<Body>, from<Gcrf>, measured(x), reference(x), none, reference(y)); }),
      "triad(vector in " + frame_name<Body>() + "): |r| is 0; a zero vector has no direction");
}

TEST(Triad, FlowsThroughOtherScalars) {
  const auto r_b = vector<si::dimensionless>(in<Body>, Eigen::Vector3f(1, 2, 2));
  const auto s_b = vector<si::dimensionless>(in<Body>, Eigen::Vector3f(2, -2, 1));
  const auto r_a = vector<si::dimensionless>(in<Gcrf>, Eigen::Vector3f(3, 0, 0));
  const auto s_a = vector<si::dimensionless>(in<Gcrf>, Eigen::Vector3f(0, 3, 0));
  const Dcm<Body, Gcrf, float> R = triad(to<Body>, from<Gcrf>, r_b, r_a, s_b, s_a);
  EXPECT_LE((R * r_a - r_b).coordinates().norm(), 1e-6F);
}

}  // namespace
}  // namespace triad_test
