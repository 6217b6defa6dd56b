#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/log.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace exp_log_test {
namespace {

using std::numbers::pi;
using Extended = Eigen::Matrix<long double, 3, 1>;

// Relative: norm, sine or arc tangent, quotient and product round once or twice each.
constexpr double few_ulps = 6 * epsilon;
// Of log(exp()) through nine numbers, relative to the angle.
constexpr double ulps_by_dcm = 16 * epsilon;

RotationVector<Gcrf, Body> turn(const Eigen::Vector3d& theta) {
  return rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta));
}
Quaternion<Gcrf, Body> unit(const Eigen::Quaterniond& q) {
  return quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
}

/// Rotation vectors of every size from 1e-300 to pi, about axes and diagonals, including the sizes where the
/// series begin.
std::vector<Eigen::Vector3d> rotation_vectors() {
  std::vector<double> angles{pi,         std::nextafter(pi, 0.0),
                             pi - 1e-15, pi - 1e-12,
                             pi - 1e-8,  3.0,
                             2.0,        1.0,
                             pi / 2.0,   0.5,
                             0.1,        0.0100001,
                             0.01,       0.0099999,
                             0.0200003,  0.02,
                             0.0199999};
  for (double angle = 1e-3; angle > 1e-300; angle /= 31.7) angles.push_back(angle);
  angles.push_back(1e-300);
  std::vector<Eigen::Vector3d> list;
  const Eigen::Vector3d axes[] = {{1, 0, 0}, {0, 1, 0},   {0, 0, 1},  {1, 1, 0},  {0, -1, 1},
                                  {1, 1, 1}, {-1, 2, -3}, {-1, 0, 0}, {0, 0, -1}, {1e-9, 1, 0}};
  for (const double angle : angles) {
    for (const auto& axis : axes) {
      Eigen::Vector3d theta = angle * axis.normalized();
      // Rounding may have made it longer than half a turn; then the opposite rotation is shorter.
      while (theta.cast<long double>().norm() > std::numbers::pi_v<long double>) theta *= 1 - epsilon;
      list.push_back(theta);
    }
  }
  return list;
}

TEST(Exp, IsAccurateToRoundingForEveryAngle) {
  for (const auto& theta : rotation_vectors()) {
    const Extended exact = theta.cast<long double>();
    const long double angle = std::sqrt(exact.squaredNorm());
    const Extended axis = std::sin(angle / 2) / angle * exact;
    const auto q = exp_quaternion(turn(theta)).eigen();
    EXPECT_LE((q.vec().cast<long double>() - axis).norm(), few_ulps * axis.norm()) << theta.transpose();
    EXPECT_LE(std::abs(q.w() - std::cos(angle / 2)), epsilon) << theta.transpose();
  }
}

TEST(Exp, IsRodriguesFormula) {
  for (const auto& theta : rotation_vectors()) {
    const Extended exact = theta.cast<long double>();
    const long double angle = std::sqrt(exact.squaredNorm());
    Eigen::Matrix<long double, 3, 3> K;
    const Extended n = exact / angle;
    K << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
    const Eigen::Matrix<long double, 3, 3> R =
        Eigen::Matrix<long double, 3, 3>::Identity() + std::sin(angle) * K + (1 - std::cos(angle)) * K * K;
    EXPECT_LE(distance(exp(turn(theta)).matrix(), R.cast<double>()), rounding) << theta.transpose();
  }
}

// Turning a by theta_ab gives b: exp(theta_ab) = R_a_from_b, as Eigen's AngleAxis and the inverse of
// turned_z.
TEST(Exp, TurnsAOntoB) {
  const Dcm<Gcrf, Body> R_a_from_b = exp(turn({0, 0, 0.7}));
  EXPECT_LE(
      distance(R_a_from_b.matrix(), Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix()),
      rounding);
  EXPECT_LE(
      distance(rotate(exp(turn({0, 0, pi / 2})), unit_x(in<Gcrf>)).coordinates(), Eigen::Vector3d::UnitY()),
      epsilon);
}

TEST(Exp, OfNothingIsTheIdentity) {
  EXPECT_EQ(exp(turn(Eigen::Vector3d::Zero())).matrix(), Eigen::Matrix3d::Identity());
}

TEST(Exp, OfAnOverflowingAngleIsBadInput) {
  const auto text = message<BadInput>([] { exp(turn({1e200, 0, 0})); });
  EXPECT_TRUE(contains(text, "exp(rotation vector of ")) << text;
  EXPECT_TRUE(contains(text, "Body relative to ") && contains(text, "Gcrf): |theta|^2 is inf")) << text;
  const auto narrow =
      rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, Eigen::Vector3f(1e30f, 0, 0)));
  EXPECT_TRUE(contains(message<BadInput>([&] { exp(narrow); }), "|theta|^2 is inf"));
}

TEST(Log, IsAccurateToRoundingForEveryAngle) {
  for (const auto& theta : rotation_vectors()) {
    const auto q = exp_quaternion(turn(theta));
    const Extended v = q.eigen().vec().cast<long double>();
    const long double length = std::sqrt(v.squaredNorm());
    const Extended exact = 2 * std::atan2(length, static_cast<long double>(q.eigen().w())) / length * v;
    EXPECT_LE((log(q).coordinates().cast<long double>() - exact).norm(), few_ulps * exact.norm())
        << theta.transpose();
  }
}

TEST(Log, UndoesExp) {
  for (const auto& theta : rotation_vectors()) {
    EXPECT_LE((log(exp_quaternion(turn(theta))).coordinates() - theta).norm(), few_ulps * theta.norm())
        << theta.transpose();
    const Eigen::Vector3d by_dcm = log(exp(turn(theta))).coordinates();
    // Within rounding of pi, nine numbers cannot distinguish +n from -n.
    const bool either_sign = theta.norm() > pi - 1e-14;
    const double difference =
        either_sign ? std::min((by_dcm - theta).norm(), (by_dcm + theta).norm()) : (by_dcm - theta).norm();
    EXPECT_LE(difference, ulps_by_dcm * theta.norm()) << theta.transpose();
  }
}

RC_GTEST_PROP(Log, ExpUndoesIt, ()) {
  const auto R = trust_dcm(to<Gcrf>, from<Body>, *rotation_matrix());
  RC_ASSERT(distance(exp(log(R)).matrix(), R.matrix()) <= rounding);
}

RC_GTEST_PROP(Log, IsNeverLongerThanPi, ()) {
  const auto q = *attitude();
  const double limit = pi * (1 + few_ulps);
  RC_ASSERT(log(unit(q)).angle().value() <= limit);
  RC_ASSERT(log(dcm(unit(q))).angle().value() <= limit);
}

RC_GTEST_PROP(Log, TheSignOfTheQuaternionDoesNotMatter, ()) {
  const auto q = *attitude();
  const Eigen::Quaterniond minus(-q.coeffs());
  RC_ASSERT(log(unit(q)).coordinates() == log(unit(minus)).coordinates());
}

TEST(Log, AtPiTheFirstNonZeroComponentOfTheAxisIsPositive) {
  const Eigen::Vector3d axes[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},  {1, -1, 0},
                                  {1, 0, 1},  {1, 0, -1}, {0, 1, 1},  {0, 1, -1}, {1, 1, 1},
                                  {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
  for (const auto& axis : axes) {
    const Eigen::Vector3d n = axis.normalized();
    for (const double sign : {1.0, -1.0}) {
      const auto half =
          quaternion_scalar_first(to<Gcrf>, from<Body>, 0.0, sign * n.x(), sign * n.y(), sign * n.z());
      EXPECT_LE(distance(log(half).coordinates(), pi * n), pi * few_ulps) << axis.transpose();
    }
    const Eigen::Matrix3d R = 2 * n * n.transpose() - Eigen::Matrix3d::Identity();
    EXPECT_LE(distance(log(trust_dcm(to<Gcrf>, from<Body>, R)).coordinates(), pi * n), pi * few_ulps)
        << axis.transpose();
  }
}

TEST(Log, OfTheIdentityIsZero) {
  EXPECT_EQ(log(aligned(to<Gcrf>, from<Body>)).coordinates(), Eigen::Vector3d::Zero());
}

TEST(RotationVector, ItsCoordinatesAreThoseInBothFramesAndReverse) {
  const auto theta = turn({0.1, -0.2, 0.2});
  EXPECT_DOUBLE_EQ(theta.angle().value(), 0.3);
  EXPECT_EQ(theta.in_reference().coordinates(), theta.in_turned().coordinates());
  EXPECT_LE(distance((exp(theta) * theta.in_turned()).coordinates(), theta.in_reference().coordinates()),
            rounding);
  const RotationVector<Body, Gcrf> back = -theta;
  EXPECT_LE(distance(exp(back).matrix(), inverse(exp(theta)).matrix()), rounding);
}

static_assert(!std::is_convertible_v<Vector<Body, si::angle>, RotationVector<Gcrf, Body>>);
static_assert(!std::is_convertible_v<RotationVector<Gcrf, Body>, RotationVector<Body, Gcrf>>);

}  // namespace
}  // namespace exp_log_test
