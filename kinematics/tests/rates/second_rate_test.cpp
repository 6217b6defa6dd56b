#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace second_rate_test {
namespace {

using Second = AngularAcceleration<Gcrf, Body, In<Body>>;

Motion<Gcrf, Body> any_motion() {
  return Motion<Gcrf, Body>(turning<Gcrf, Body>(0.7, instant(*coordinate())));
}
/// The second derivative depends on the squares of the rates, and linearly on the accelerations.
double tolerance(const Motion<Gcrf, Body>& ab) {
  return motion_tolerance * std::max(1.0, ab.Rddot.norm());
}

// Rddot = R ([w^b]x^2 + [alpha^b]x) = ([w^a]x^2 + [alpha^a]x) R
RC_GTEST_PROP(DcmSecondRate, IsTheDerivativeInBothFramesAndBothWays, ()) {
  const auto ab = any_motion();
  const auto R = ab.rotation();
  const DcmSecondRate<Gcrf, Body> body = second_rate(R, ab.w_ab_b(), ab.alpha_ab_b());
  const auto reference = second_rate(R, R * ab.w_ab_b(), R * ab.alpha_ab_b());
  RC_ASSERT(distance(body.matrix(), ab.Rddot) <= tolerance(ab));
  RC_ASSERT(distance(reference.matrix(), ab.Rddot) <= tolerance(ab));

  const auto Rdot = dcm_rate(R, ab.Rdot);
  const auto Rddot = dcm_second_rate(R, Rdot, ab.Rddot);
  const Second alpha_b = angular_acceleration_from(R, Rdot, Rddot, in<Body>);
  const AngularAcceleration<Gcrf, Body, In<Gcrf>> alpha_a =
      angular_acceleration_from(R, Rdot, Rddot, in<Gcrf>);
  RC_ASSERT(distance(alpha_b.coordinates(), ab.alpha_ab_b().coordinates()) <= tolerance(ab));
  RC_ASSERT(distance(alpha_a.coordinates(), ab.alpha_a()) <= tolerance(ab));
}

TEST(DcmSecondRate, ItsDoorTakesOnlyOneOfThatRotationAndRate) {
  const Motion<Gcrf, Body> ab(turning<Gcrf, Body>(0.7, instant(0.3)));
  const auto R = ab.rotation();
  const auto Rdot = dcm_rate(R, ab.Rdot);
  const auto said = [&](const Eigen::Matrix3d& matrix) {
    return message<BadInput>([&] { dcm_second_rate(R, Rdot, matrix); });
  };
  EXPECT_TRUE(contains(said(Eigen::Matrix3d::Zero()), "symmetric part of R^T Rddot differs from [w]x^2 by"));
  EXPECT_TRUE(contains(said(ab.Rdot), "second derivative of R("));
  Eigen::Matrix3d bad = ab.Rddot;
  bad(2, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(said(bad), "of R^T times it entry (1, 1) is nan")) << said(bad);
  // Rotation at a constant rate: the second derivative is centripetal only, and the angular acceleration is
  // zero.
  const auto steady = second_rate(R, ab.w_ab_b(), unaccelerated(of<Body>, relative_to<Gcrf>, in<Body>));
  const auto alpha = angular_acceleration_from(R, Rdot, dcm_second_rate(R, Rdot, steady.matrix()), in<Gcrf>);
  EXPECT_LE(alpha.coordinates().norm(), tolerance(ab));
}

// qddot = q (-|w|^2/4, alpha^b/2) = (-|w|^2/4, alpha^a/2) q, compared with Rddot by the product rule for
// R(q).
RC_GTEST_PROP(QuaternionSecondRate, IsTheDerivativeInBothFramesAndBothWays, ()) {
  const auto ab = any_motion();
  const auto q = quaternion(ab.rotation());
  const auto alpha_a_given = ab.rotation() * ab.alpha_ab_b();
  const auto qdot = rate(q, ab.w_ab_b());
  const QuaternionSecondRate<Gcrf, Body> body = second_rate(q, ab.w_ab_b(), ab.alpha_ab_b());
  const auto reference = second_rate(q, ab.rotation() * ab.w_ab_b(), alpha_a_given);
  RC_ASSERT(distance(body.eigen().coeffs(), reference.eigen().coeffs()) <= tolerance(ab));

  const auto moving_number = [&](std::size_t i) {
    const Eigen::Matrix<double, 1, 1> first(qdot.scalar_first()[i]), second(body.scalar_first()[i]);
    return Dual2(Dual(q.scalar_first()[i], first), Eigen::Matrix<Dual, 1, 1>(Dual(first(0), second)));
  };
  const Eigen::Quaternion<Dual2> moving(moving_number(0), moving_number(1), moving_number(2),
                                        moving_number(3));
  const Eigen::Matrix<Dual2, 3, 3> R = moving.toRotationMatrix();
  const Eigen::Matrix3d Rddot = R.unaryExpr([](const Dual2& x) { return second(x); });
  RC_ASSERT(distance(Rddot, ab.Rddot) <= tolerance(ab));

  const auto w_b = angular_velocity_from(q, qdot, in<Body>);
  const auto w_a = angular_velocity_from(q, qdot, in<Gcrf>);
  RC_ASSERT(distance(w_b.coordinates(), ab.w_ab_b().coordinates()) <= motion_tolerance);
  RC_ASSERT(distance(w_a.coordinates(), ab.w_a()) <= motion_tolerance);
  const Second alpha_b = angular_acceleration_from(q, qdot, body, in<Body>);
  const auto alpha_a = angular_acceleration_from(q, qdot, body, in<Gcrf>);
  RC_ASSERT(distance(alpha_b.coordinates(), ab.alpha_ab_b().coordinates()) <= tolerance(ab));
  RC_ASSERT(distance(alpha_a.coordinates(), ab.alpha_a()) <= tolerance(ab));
}

TEST(QuaternionRate, ItsDoorsTakeOnlyWhatKeepsTheNorm) {
  const Motion<Gcrf, Body> ab(turning<Gcrf, Body>(0.7, instant(0.3)));
  const auto q = quaternion(ab.rotation());
  const auto qdot = rate(q, ab.w_ab_b());
  const double w = qdot.eigen().w(), x = qdot.eigen().x(), y = qdot.eigen().y(), z = qdot.eigen().z();
  EXPECT_EQ(quaternion_rate_scalar_first(q, w, x, y, z).eigen().coeffs(), qdot.eigen().coeffs());
  EXPECT_EQ(quaternion_rate_scalar_last(q, x, y, z, w).eigen().coeffs(), qdot.eigen().coeffs());
  // If the numbers are in the wrong order, the norm is not constant.
  const auto mistaken = message<BadInput>([&] { quaternion_rate_scalar_last(q, w, x, y, z); });
  EXPECT_TRUE(contains(mistaken, "derivative of q(")) << mistaken;
  EXPECT_TRUE(contains(mistaken, "the norm of q would leave 1")) << mistaken;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(message<BadInput>([&] { quaternion_rate_scalar_first(q, nan, x, y, z); }), "finite"));
}

TEST(QuaternionSecondRate, ItsDoorsTakeOnlyOneOfThatAttitudeAndRate) {
  const Motion<Gcrf, Body> ab(turning<Gcrf, Body>(0.7, instant(0.3)));
  const auto q = quaternion(ab.rotation());
  const auto qdot = rate(q, ab.w_ab_b());
  const auto qddot = second_rate(q, ab.w_ab_b(), ab.alpha_ab_b());
  const double w = qddot.eigen().w(), x = qddot.eigen().x(), y = qddot.eigen().y(), z = qddot.eigen().z();
  EXPECT_EQ(quaternion_second_rate_scalar_first(q, qdot, w, x, y, z).eigen().coeffs(),
            qddot.eigen().coeffs());
  EXPECT_EQ(quaternion_second_rate_scalar_last(q, qdot, x, y, z, w).eigen().coeffs(), qddot.eigen().coeffs());
  const auto doubled = rate(q, angular_velocity(of<Body>, relative_to<Gcrf>, ab.w_ab_b().vector() * 2.0));
  const auto text = message<BadInput>([&] { quaternion_second_rate_scalar_first(q, doubled, w, x, y, z); });
  EXPECT_TRUE(contains(text, "second derivative of q(")) << text;
}

}  // namespace
}  // namespace second_rate_test
