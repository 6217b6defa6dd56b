#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/log.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace axis_angle_test {
namespace {

using std::numbers::pi;

/// Relative: a norm, and an arc tangent or a sine, round three times.
constexpr double few_ulps = 6 * epsilon;

AxisAngle<Gcrf, Body> turn(double angle, const Eigen::Vector3d& axis) {
  return axis_angle(of<Body>, relative_to<Gcrf>, vector<si::dimensionless>(in<Gcrf>, axis),
                    angle * si::radian);
}
const Eigen::Vector3d axes[] = {Eigen::Vector3d(2, -1, 2) / 3, Eigen::Vector3d::UnitZ(),
                                Eigen::Vector3d(-0.6, 0, 0.8), Eigen::Vector3d(1e-9, 1, 0)};

// Turning a by (phi, n) gives b: Eigen's AngleAxis makes R_a_from_b.
TEST(AxisAngle, TheirMatrixIsThatOfEigen) {
  for (const double angle : {0.0, 1e-9, 0.5, pi / 2, 3.0, pi, 5.0, -1.0, 100.0}) {
    for (const auto& axis : axes) {
      const Dcm<Gcrf, Body> R = dcm(turn(angle, axis));
      EXPECT_LE(distance(R.matrix(), Eigen::AngleAxisd(angle, axis).toRotationMatrix()), rounding);
    }
  }
  EXPECT_LE(distance(dcm(turn(0.7, axes[1])).matrix(),
                     inverse(turned_z(to<Body>, from<Gcrf>, 0.7 * si::radian)).matrix()),
            epsilon);
}

RC_GTEST_PROP(AxisAngle, OfEveryRotationAreTheShortestAndComeBack, ()) {
  const auto R = trust_dcm(to<Gcrf>, from<Body>, *rotation_matrix());
  const auto x = axis_angle(R);
  RC_ASSERT(distance(dcm(x).matrix(), R.matrix()) <= rounding);
  const double angle = x.angle().value();
  RC_ASSERT(angle >= 0 && angle <= pi);
  RC_ASSERT(std::abs(x.in_turned().coordinates().norm() - 1) <= few_ulps);
  RC_ASSERT(distance(x.rotation_vector().coordinates(), log(R).coordinates()) <= rounding);
}

TEST(AxisAngle, AreAccurateForEveryAngle) {
  std::vector<double> angles{0.5, 1, 2, 3, pi - 1e-6, pi - 1e-10};
  for (double angle = 0.1; angle > 1e-300; angle /= 317) angles.push_back(angle);
  for (const double angle : angles) {
    for (const auto& axis : axes) {
      const auto x = axis_angle(quaternion(turn(angle, axis)));
      EXPECT_LE(std::abs(x.angle().value() - angle), few_ulps * angle);
      EXPECT_LE((x.in_reference().coordinates() - axis).norm(), few_ulps) << angle;
    }
  }
}

TEST(AxisAngle, AtHalfATurnTheFirstNonZeroComponentIsPositive) {
  for (const double sign : {1.0, -1.0}) {
    const auto q = quaternion_scalar_first(to<Gcrf>, from<Body>, 0.0, 0.0, sign * 0.6, -sign * 0.8);
    const auto x = axis_angle(q);
    EXPECT_EQ(x.angle().value(), pi);
    EXPECT_LE(distance(x.in_turned().coordinates(), Eigen::Vector3d(0, 0.6, -0.8)), epsilon);
  }
}

TEST(AxisAngle, OfNoTurnHaveTheFirstAxisAndNoDistance) {
  const auto x = axis_angle(aligned(to<Gcrf>, from<Body>));
  EXPECT_EQ(x.coordinates(), Eigen::Vector4d(0, 1, 0, 0));
  EXPECT_EQ(x.distance_from_singularity().value(), 0.0);
  EXPECT_NEAR(turn(2 * pi - 0.25, axes[0]).distance_from_singularity().value(), 0.25, rounding);
  EXPECT_NEAR(turn(-1e-9, axes[0]).distance_from_singularity().value(), 1e-9, 1e-9 * few_ulps);
}

TEST(AxisAngle, BackIsAboutTheOppositeAxis) {
  const auto x = turn(0.7, axes[0]);
  const AxisAngle<Body, Gcrf> back = -x;
  EXPECT_LE(distance(dcm(back).matrix(), inverse(dcm(x)).matrix()), rounding);
  EXPECT_EQ(exp(x.rotation_vector()).matrix(), exp(turn(-0.7, -axes[0]).rotation_vector()).matrix());
}

TEST(AxisAngle, TheirDoorTakesAUnitVectorAndAFiniteAngle) {
  const auto text = message<BadInput>([] { turn(0.5, {1, 1, 0}); });
  EXPECT_TRUE(contains(text, "axis_angle(angle and axis of ")) << text;
  EXPECT_TRUE(contains(text, "the square of the axis differs from 1 by 1, tolerance 2.4e-10")) << text;
  EXPECT_TRUE(contains(text, "direction() projects")) << text;
  for (const double sign : {-1.0, 1.0}) {
    const auto said = [&](double part) {
      return message<BadInput>([&] { turn(0.5, {0, 1 + sign * part * unit_norm_tolerance, 0}); });
    };
    EXPECT_EQ(said(0.999), "");
    EXPECT_NE(said(1.001), "");
  }
  const auto infinite = message<BadInput>([] { turn(std::numeric_limits<double>::infinity(), axes[1]); });
  EXPECT_TRUE(contains(infinite, "the numbers (inf, 0, 0, 1) are not finite")) << infinite;
}

TEST(AxisAngle, SayWhatTheyAre) {
  std::ostringstream out;
  out << turn(0.5, axes[1]);
  EXPECT_EQ(out.str(), "(0.5, 0, 0, 1) (rad, 1), angle and axis of " + frame_name<Body>() + " relative to " +
                           frame_name<Gcrf>());
}

}  // namespace
}  // namespace axis_angle_test
