#include <gtest/gtest.h>

#include <random>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/attitude/euler_angles.hpp>

#include "sequences.hpp"
#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace euler_angles_test {
namespace {

using std::numbers::pi;

/// A product of three rotations, and its inverse: each entry is a sum of products with one rounding each.
constexpr double few_ulps = 8 * epsilon;
/// Closer than this to a singularity the third angle is set to zero; the resulting difference of the entries
/// remains.
constexpr double choice = 8 * epsilon;

/// Random triples of angles. The second angle is also near zero, a quarter and half a turn, down to the
/// distance of one rounding. And quarter turns in all three.
std::vector<Eigen::Vector3d> triples() {
  std::mt19937_64 random(20261102);
  std::uniform_real_distribution<double> turn(-pi, pi);
  std::vector<Eigen::Vector3d> list;
  for (int i = 0; i < 200; ++i) list.emplace_back(turn(random), turn(random), turn(random));
  for (double away = 1e-1; away > 1e-17; away /= 31.7) {
    for (const double centre : {0.0, pi / 2, -pi / 2, pi}) {
      list.emplace_back(turn(random), centre + away, turn(random));
      list.emplace_back(turn(random), centre - away, turn(random));
    }
  }
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) {
      for (int c = -2; c <= 2; ++c) list.emplace_back(a * pi / 2, b * pi / 2, c * pi / 2);
    }
  }
  return list;
}
const std::vector<Eigen::Vector3d>& all_triples() {
  static const auto list = triples();
  return list;
}

template <class Sequence> EulerAngles<Sequence, Gcrf, Body> angles_of(const Eigen::Vector3d& t) {
  return euler_angles(Sequence{}, of<Body>, relative_to<Gcrf>, t(0) * si::radian, t(1) * si::radian,
                      t(2) * si::radian);
}
/// The difference of two angles, modulo 2 pi.
double apart(double angle, double other) {
  return std::abs(std::remainder(angle - other, 2 * pi));
}

/// The law's matrix in long double.
Eigen::Matrix3d exact(const Turns& turns, const Eigen::Vector3d& t) {
  const Eigen::Matrix<long double, 3, 1> angles = t.cast<long double>();
  return product_of(turns, angles).cast<double>();
}
/// The same matrix by Eigen's AngleAxis.
Eigen::Matrix3d eigens(const Turns& turns, const Eigen::Vector3d& t) {
  const auto turn = [&](std::size_t n) {
    return Eigen::AngleAxisd(t(Eigen::Index(n)), Eigen::Vector3d::Unit(turns.axes[n]));
  };
  const Eigen::Quaterniond q = turns.intrinsic ? turn(0) * turn(1) * turn(2) : turn(2) * turn(1) * turn(0);
  return q.toRotationMatrix();
}

template <class Sequence> class Euler : public testing::Test {};
TYPED_TEST_SUITE(Euler, Sequences);

TYPED_TEST(Euler, TheirMatrixIsTheProductOfTheirTurns) {
  for (const auto& t : all_triples()) {
    const auto x = angles_of<TypeParam>(t);
    const Eigen::Matrix3d R = dcm(x).matrix();
    const double off[] = {distance(R, exact(turns_of(TypeParam{}), t)),
                          distance(R, eigens(turns_of(TypeParam{}), t)),
                          distance(R, dcm(quaternion(x)).matrix())};
    for (const double error : off) EXPECT_LE(error, few_ulps) << t.transpose();
  }
}

// R -> angles -> R, also where the angles that made R cannot be recovered.
TYPED_TEST(Euler, OfEveryRotationMakeThatRotation) {
  std::vector<Eigen::Matrix3d> list;
  for (const auto& t : all_triples()) list.push_back(dcm(angles_of<TypeParam>(t)).matrix());
  for (const auto& q : hard_attitudes()) list.push_back(q.toRotationMatrix());
  for (const Eigen::Matrix3d& R : list) {
    const auto x = euler_angles(TypeParam{}, trust_dcm(to<Gcrf>, from<Body>, R));
    EXPECT_LE(distance(dcm(x).matrix(), R), few_ulps + choice) << R;
    const Eigen::Vector3d t = x.coordinates();
    EXPECT_LE(std::max(std::abs(t(0)), std::abs(t(2))), pi);
    EXPECT_GE(t(1), TypeParam::proper ? 0.0 : -pi / 2);
    EXPECT_LE(t(1), TypeParam::proper ? pi : pi / 2);
  }
}

// angles -> R -> angles, to rounding, as near to the singularity as R can distinguish them.
TYPED_TEST(Euler, ComeBackFromTheirMatrixToRounding) {
  for (const auto& given : all_triples()) {
    Eigen::Vector3d t = given;
    if (TypeParam::proper) t(1) = std::abs(t(1));
    const auto x = angles_of<TypeParam>(t);
    if (!TypeParam::proper && std::abs(t(1)) > pi / 2) continue;  // the same rotation by other angles
    if (TypeParam::proper && t(1) > pi) continue;
    if (x.distance_from_singularity().value() <= 2 * choice) continue;
    const Eigen::Vector3d back = euler_angles(TypeParam{}, dcm(x)).coordinates();
    const double off = std::max({apart(back(0), t(0)), apart(back(1), t(1)), apart(back(2), t(2))});
    EXPECT_LE(off, pi * few_ulps) << t.transpose();
  }
}

TYPED_TEST(Euler, AtTheSingularityTheThirdIsZeroAndTheDistanceToldAbout) {
  for (const double turned : {0.0, pi}) {
    const double second = TypeParam::proper ? turned : turned - pi / 2;
    const auto given = angles_of<TypeParam>(Eigen::Vector3d(0.3, second, 0.5));
    const auto x = euler_angles(TypeParam{}, dcm(given));
    EXPECT_EQ(x.third().value(), 0.0);
    EXPECT_LE(std::min(apart(x.first().value(), 0.8), apart(x.first().value(), -0.2)), few_ulps);
    EXPECT_LE(std::abs(x.second().value() - second), epsilon * pi);
    EXPECT_LE(x.distance_from_singularity().value(), 2 * epsilon);
  }
}

template <class Sequence> void expect_eigens_angles(Sequence, const Eigen::Matrix3d& R) {
  const auto turns = turns_of(Sequence{});
  const Eigen::Vector3d t = R.eulerAngles(turns.axes[0], turns.axes[1], turns.axes[2]);
  EXPECT_LE(distance(dcm(angles_of<Sequence>(t)).matrix(), R), rounding) << R;
}

// m = AngleAxis(ea[0], axis 0) * AngleAxis(ea[1], axis 1) * AngleAxis(ea[2], axis 2) is R_a_from_b.
TEST(EulerAngles, OfEigenAreIntrinsicAndOfTheMatrixOfTheTurnedFrame) {
  std::mt19937_64 random(20261103);
  std::normal_distribution<double> number;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Quaterniond q(number(random), number(random), number(random), number(random));
    const Eigen::Matrix3d R = q.normalized().toRotationMatrix();
    expect_eigens_angles(intrinsic<3, 2, 1>, R);
    expect_eigens_angles(intrinsic<1, 2, 3>, R);
    expect_eigens_angles(intrinsic<2, 3, 1>, R);
    expect_eigens_angles(intrinsic<3, 1, 3>, R);
    expect_eigens_angles(intrinsic<1, 3, 1>, R);
    expect_eigens_angles(intrinsic<2, 1, 2>, R);
  }
}

// The matrix from a to b of yaw, pitch and roll, as printed in flight mechanics.
TEST(EulerAngles, Of321AreYawPitchAndRoll) {
  const double yaw = 0.4, pitch = -0.7, roll = 2.1;
  const auto R_b_from_a = inverse(dcm(angles_of<Intrinsic<3, 2, 1>>({yaw, pitch, roll})));
  const auto& R = R_b_from_a.matrix();
  EXPECT_NEAR(R(0, 0), std::cos(pitch) * std::cos(yaw), epsilon);
  EXPECT_NEAR(R(0, 1), std::cos(pitch) * std::sin(yaw), epsilon);
  EXPECT_NEAR(R(0, 2), -std::sin(pitch), epsilon);
  EXPECT_NEAR(R(1, 2), std::cos(pitch) * std::sin(roll), epsilon);
  EXPECT_NEAR(R(2, 2), std::cos(pitch) * std::cos(roll), epsilon);
  const Dcm<Body, Gcrf> by_turns = turned_x(to<Body>, from<Camera>, roll * si::radian) *
                                   turned_y(to<Camera>, from<Itrf>, pitch * si::radian) *
                                   turned_z(to<Itrf>, from<Gcrf>, yaw * si::radian);
  EXPECT_LE(distance(R, by_turns.matrix()), few_ulps);
}

// Intrinsic<i, j, k> of (t1, t2, t3) is Extrinsic<k, j, i> of (t3, t2, t1), and not of (t1, t2, t3).
TEST(EulerAngles, ExtrinsicAreIntrinsicInReverse) {
  const Eigen::Vector3d t(0.3, -0.8, 1.9);
  const auto inner = dcm(angles_of<Intrinsic<3, 2, 1>>(t)).matrix();
  EXPECT_LE(distance(inner, dcm(angles_of<Extrinsic<1, 2, 3>>(t.reverse())).matrix()), few_ulps);
  EXPECT_GT(distance(inner, dcm(angles_of<Extrinsic<3, 2, 1>>(t)).matrix()), visible);
  EXPECT_GT(distance(inner, dcm(angles_of<Intrinsic<1, 2, 3>>(t)).matrix()), visible);
}

template <class S> void expect_round_trip() {
  const S tolerance = 8 * std::numeric_limits<S>::epsilon();
  const auto angle = [](double t) { return Quantity<si::angle, S>::from_value(S(t)); };
  const auto check = [&](auto sequence) {
    const auto x = euler_angles(sequence, of<Body>, relative_to<Gcrf>, angle(-2.5), angle(1.25), angle(0.75));
    const auto back = euler_angles(sequence, quaternion(x)).coordinates();
    EXPECT_LE((back - x.coordinates()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>(), 8 * tolerance);
    EXPECT_LE((euler_angles(sequence, dcm(x)).coordinates() - x.coordinates())
                  .cwiseAbs()
                  .template maxCoeff<Eigen::PropagateNaN>(),
              4 * tolerance);
  };
  check(intrinsic<3, 2, 1>);
  check(extrinsic<3, 1, 3>);
}
TEST(EulerAngles, AreOfAnyFloatingType) {
  expect_round_trip<float>();
  expect_round_trip<double>();
  expect_round_trip<long double>();
}

TEST(EulerAngles, TheirDoorTakesFiniteAngles) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto text = message<BadInput>([&] { angles_of<Intrinsic<3, 1, 3>>({0.5, infinity, 1}); });
  EXPECT_TRUE(contains(text, "euler_angles(Euler angles intrinsic 3-1-3 of ")) << text;
  EXPECT_TRUE(contains(text, "Body relative to ")) << text;
  EXPECT_TRUE(contains(text, "the numbers (0.5, inf, 1) are not finite")) << text;
  const auto whole = angles_of<Intrinsic<3, 1, 3>>({100, 200, 300});
  EXPECT_EQ(whole.second().value(), 200);
}

TYPED_TEST(Euler, NeverMinusZeroAndHalfATurnIsPi) {
  using Eigen::Matrix3d;
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double zero : {0.0, -0.0}) {
        Matrix3d R = Matrix3d::Constant(zero);
        R.diagonal() << x, y, x * y;
        const auto angles = euler_angles(TypeParam{}, dcm(to<Gcrf>, from<Body>, R)).coordinates();
        for (const double angle : angles) {
          EXPECT_FALSE(angle == 0.0 && std::signbit(angle)) << R;
          EXPECT_NE(angle, -std::numbers::pi) << R;
        }
      }
}

TEST(EulerAngles, SayHowNearTheyAreToTheSingularity) {
  const auto near = [](auto sequence, double second) {
    return angles_of<decltype(sequence)>({1, second, 2}).distance_from_singularity().value();
  };
  EXPECT_NEAR(near(intrinsic<3, 2, 1>, 1.5), pi / 2 - 1.5, epsilon);
  EXPECT_NEAR(near(intrinsic<3, 2, 1>, -1.75), 1.75 - pi / 2, epsilon);
  EXPECT_NEAR(near(extrinsic<3, 2, 1>, 0.0), pi / 2, epsilon);
  EXPECT_NEAR(near(intrinsic<3, 1, 3>, -1e-9), 1e-9, 1e-9 * epsilon);
  EXPECT_NEAR(near(intrinsic<3, 1, 3>, 3.0), pi - 3.0, epsilon);
  EXPECT_NEAR(near(extrinsic<3, 1, 3>, pi / 2), pi / 2, epsilon);
}

TEST(EulerAngles, SayWhatTheyAre) {
  std::ostringstream out;
  out << angles_of<Extrinsic<1, 2, 3>>({0.25, 0.5, -1});
  EXPECT_EQ(out.str(), "(0.25, 0.5, -1) rad, Euler angles extrinsic 1-2-3 of " + frame_name<Body>() +
                           " relative to " + frame_name<Gcrf>());
}

static_assert(EulerSequence<Intrinsic<3, 2, 1>> && EulerSequence<Extrinsic<3, 1, 3>>);
static_assert(!EulerSequence<Intrinsic<3, 3, 1>> && !EulerSequence<Extrinsic<1, 2, 2>>);
static_assert(!EulerSequence<Intrinsic<0, 1, 2>> && !EulerSequence<Extrinsic<1, 2, 4>>);

template <class S> using Ours = EulerAngles<S, Gcrf, Body>;
static_assert(!std::is_convertible_v<Ours<Intrinsic<3, 2, 1>>, Ours<Extrinsic<3, 2, 1>>>);
static_assert(!std::is_convertible_v<Ours<Intrinsic<3, 2, 1>>, Ours<Intrinsic<3, 1, 3>>>);
static_assert(!std::is_convertible_v<Ours<Intrinsic<3, 2, 1>>, EulerAngles<Intrinsic<3, 2, 1>, Body, Gcrf>>);

}  // namespace
}  // namespace euler_angles_test
