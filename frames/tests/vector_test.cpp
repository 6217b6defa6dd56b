#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/vector.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace vector_test {
namespace {

// Three components below 1: one product and a sum of three.
constexpr double tolerance = 8 * epsilon;

template <class F, class U> Vector<F, U> any() {
  return vector<U>(in<F>, *triple());
}

RC_GTEST_PROP(Vector, SumsAreThoseOfTheCoordinates, ()) {
  const auto r = any<Body, si::length>();
  const auto s = any<Body, si::length>();
  RC_ASSERT((r + s).coordinates() == r.coordinates() + s.coordinates());
  RC_ASSERT((r - s).coordinates() == (r + -s).coordinates());
  RC_ASSERT((2.0 * r).coordinates() == (r + r).coordinates());
  RC_ASSERT((r * 2.0 / 2.0).coordinates() == r.coordinates());
}

RC_GTEST_PROP(Vector, CrossIsTheRightHandedProduct, ()) {
  const auto r = any<Body, si::length>();
  const auto F = any<Body, si::force>();
  const Vector<Body, si::torque> tau = cross(r, F);
  RC_ASSERT(std::abs(dot(tau, r).value()) <= tolerance);
  RC_ASSERT(std::abs(dot(tau, F).value()) <= tolerance);
  RC_ASSERT(distance(tau.coordinates(), -cross(F, r).coordinates()) == 0.0);
  RC_ASSERT(cross(unit_x(in<Body>), unit_y(in<Body>)).coordinates() == Eigen::Vector3d::UnitZ());
}

// Products of vectors of length up to sqrt(3).
constexpr double of_long = 3 * rounding;

RC_GTEST_PROP(Vector, RotationsKeepDotAndCross, ()) {
  const auto R = trust_dcm(to<Body>, from<Gcrf>, *rotation_matrix());
  const auto r = any<Gcrf, si::length>();
  const auto F = any<Gcrf, si::force>();
  RC_ASSERT(std::abs((dot(R * r, R * F) - dot(r, F)).value()) <= of_long);
  RC_ASSERT(distance(cross(R * r, R * F).coordinates(), (R * cross(r, F)).coordinates()) <= of_long);
  RC_ASSERT(std::abs((norm(R * r) - norm(r)).value()) <= of_long);
}

// From (1, e) to (1, 0), which are numbers: the angle is e - e^3/3 + ...
TEST(Vector, AngleBetweenIsAccurateNearZeroAndNearAHalfTurn) {
  for (const double e : {0.0, 1e-300, 1e-20, 1e-12, 1e-9, 1e-6}) {
    const auto r = vector<si::length>(in<Body>, Eigen::Vector3d(2.0, 0.0, 0.0));
    const auto s = vector<si::velocity>(in<Body>, Eigen::Vector3d(3.0, 3.0 * e, 0.0));
    const double angle = e - e * e * e / 3;
    EXPECT_NEAR(angle_between(r, s).value(), angle, 4 * epsilon * angle) << e;
    EXPECT_NEAR(angle_between(r, -s).value(), std::numbers::pi - angle, 4 * epsilon) << e;
  }
  EXPECT_NEAR(angle_between(unit_x(in<Body>), unit_y(in<Body>)).value(), std::numbers::pi / 2, 2 * epsilon);
}

RC_GTEST_PROP(Vector, AngleBetweenFollowsTheLengthsAndTheFrame, ()) {
  const auto r = any<Gcrf, si::length>();
  const auto s = any<Gcrf, si::force>();
  RC_PRE(norm(r).value() > 0.01 && norm(s).value() > 0.01);
  const auto angle = angle_between(r, s);
  const auto R = trust_dcm(to<Body>, from<Gcrf>, *rotation_matrix());
  RC_ASSERT(std::abs((dot(r, s) / (norm(r) * norm(s))).value() - std::cos(angle.value())) <= tolerance);
  RC_ASSERT(std::abs((angle_between(s, 1e200 * r) - angle).value()) <= 1e3 * tolerance);
  RC_ASSERT(std::abs((angle_between(R * r, R * s) - angle).value()) <= 1e3 * tolerance);
  RC_ASSERT(squared_norm(r).value() == dot(r, r).value());
}

TEST(Vector, NoAngleToTheZeroVector) {
  EXPECT_TRUE(
      contains(message<BadInput>([] { angle_between(unit_x(in<Body>), zero<si::length>(in<Body>)); }),
               "angle_between(vector in " + frame_name<Body>() + "): |r| is 0; a zero vector has no"));
  const auto overflown = 1e200 * vector<si::length>(in<Body>, Eigen::Vector3d(1e200, 0, 0));
  EXPECT_TRUE(contains(message<BadInput>([&] { angle_between(overflown, unit_x(in<Body>)); }),
                       "angle_between(vector in " + frame_name<Body>() + "): the coordinates (inf, 0, 0)"));
  EXPECT_TRUE(contains(message<BadInput>([] { direction(zero<si::length>(in<Body>)); }),
                       "direction(vector in " + frame_name<Body>() + "): |r| is 0"));
}

TEST(Vector, TakesAPartOfALongerColumn) {
  Eigen::VectorXd state(6);
  state << 1, 2, 3, 4, 5, 6;
  const Eigen::Index three = 3;
  EXPECT_EQ(vector<si::velocity>(in<Body>, state.segment(three, three)).coordinates(),
            Eigen::Vector3d(4, 5, 6));
  EXPECT_TRUE(contains(message<BadInput>([&] { vector<si::velocity>(in<Body>, state.segment(2, 4)); }),
                       "vector(in<" + frame_name<Body>() + ">): the matrix has 4 x 1 entries, not 3 x 1"));
}

TEST(Vector, TakesAPartOfAMatrixAndARow) {
  Eigen::MatrixXd poses(3, 4);
  poses << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12;
  const Eigen::Index one = 1, two = 2, three = 3;
  EXPECT_EQ(vector<si::length>(in<Body>, poses.block(0, three, three, one)).coordinates(),
            Eigen::Vector3d(4, 8, 12));
  EXPECT_EQ(vector<si::length>(in<Body>, poses.row(two).segment(one, three)).coordinates(),
            Eigen::Vector3d(10, 11, 12));
  EXPECT_EQ(vector<si::length>(in<Body>, poses.col(0).segment(0, three).transpose()).coordinates(),
            Eigen::Vector3d(1, 5, 9));
  const std::string door = "vector(in<" + frame_name<Body>() + ">): the matrix has ";
  const auto said = [](const auto& part) {
    return message<BadInput>([&] { vector<si::length>(in<Body>, part); });
  };
  EXPECT_TRUE(contains(said(poses.block(0, 0, one, three)), door + "1 x 3 entries, not 3 x 1"));
  EXPECT_TRUE(contains(said(poses.block(0, 0, three, two)), door + "3 x 2 entries, not 3 x 1"));
  EXPECT_TRUE(contains(said(poses.row(0)), door + "1 x 4 entries, not 1 x 3"));
}

TEST(Vector, NormOfEverySize) {
  for (const double size : {5e-324, 1e-200, 1e-160, 1.0, 1e160, 1e200, 1e307}) {
    const auto r = vector<si::length>(in<Body>, Eigen::Vector3d(0.0, 3.0 * size, -4.0 * size));
    EXPECT_LE(std::abs(norm(r).value() / size - 5.0), rounding) << size;
  }
  EXPECT_EQ(norm(zero<si::length>(in<Body>)).value(), 0.0);
}

TEST(Vector, CoordinatesKeepTheirUnit) {
  const auto r = vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 2.0 * si::metre);
  EXPECT_EQ(r.y(), 2.0 * si::metre);
  EXPECT_EQ(r.z(), 2.0 * si::metre);
  EXPECT_EQ(norm(r), 3.0 * si::metre);
  EXPECT_EQ(dot(r, r).value(), 9.0);
  EXPECT_EQ((zero<si::force>(in<Body>).coordinates()), Eigen::Vector3d::Zero());
}

TEST(Vector, ConversionsIntoSi) {
  EXPECT_DOUBLE_EQ(convert<si::length>(7000.0 * si::kilometre).value(), 7e6);
  EXPECT_DOUBLE_EQ(convert<si::angle>(180.0 * si::degree).value(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(convert<si::angle>(3600.0 * si::arcsecond).value(), std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(convert<si::angular_velocity>(60.0 * si::revolution_per_minute).value(),
                   2 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(convert<si::angular_velocity>(180.0 * si::degree_per_second).value(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(convert<si::time>(1.5 * si::hour).value(), 5400);
  EXPECT_DOUBLE_EQ(convert<si::time>(2.0 * si::minute).value(), 120);
  EXPECT_DOUBLE_EQ(convert<si::time>(250.0 * si::millisecond).value(), 0.25);
}

TEST(Vector, NoNumberIsBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto text =
      message<BadInput>([=] { vector(in<Body>, 1.0 * si::metre, nan * si::metre, 3.0 * si::metre); });
  EXPECT_TRUE(contains(text, "vector(in<")) << text;
  EXPECT_TRUE(contains(text, "Body>): the coordinates (1, nan, 3) are not finite")) << text;
  EXPECT_TRUE(
      contains(message<BadInput>([=] { vector<si::force>(in<Gcrf>, Eigen::Vector3d(0, 0.5, -infinity)); }),
               "Gcrf>): the coordinates (0, 0.5, -inf) are not finite"));
}

RC_GTEST_PROP(Vector, DirectionIsTheUnitVectorAtEveryScale, ()) {
  const Eigen::Vector3d coordinates = *triple();
  RC_PRE(coordinates.norm() > 1e-3);
  const Eigen::Vector3d expected = coordinates / coordinates.norm();
  // 1e-300 squared underflows, 1e300 squared overflows.
  for (const double scale : {1e-300, 1.0, 1e300}) {
    const auto n = direction(vector<si::length>(in<Body>, scale * coordinates));
    RC_ASSERT(distance(n.coordinates(), expected) <= tolerance);
  }
}

TEST(Vector, NoDirectionIsBadInput) {
  const auto zero_text = message<BadInput>([] { direction(zero<si::length>(in<Body>)); });
  EXPECT_TRUE(contains(zero_text, "Body): |r| is 0; a zero vector has no direction")) << zero_text;
  const auto huge = 1e10 * vector<si::length>(in<Body>, Eigen::Vector3d(1e300, 1, 1));
  const auto overflow = message<BadInput>([&] { direction(huge); });
  EXPECT_TRUE(contains(overflow, "the coordinates (inf, 1e+10, 1e+10) are not finite")) << overflow;
}

// The products of mechanics, where the radian counts as 1.
template <class U, class V, class Product>
concept VectorProduct = std::same_as<unit_of_vector_product<U, V>, Product>;
template <class U, class V, class Quotient>
concept VectorQuotient = std::same_as<unit_of_vector_quotient<U, V>, Quotient>;
template <class U, class V, class Product>
concept ScalarProduct = std::same_as<unit_product<U, V>, Product>;

static_assert(VectorProduct<si::angular_velocity, si::length, si::velocity>);                     // w x r
static_assert(VectorProduct<si::angular_velocity, si::velocity, si::acceleration>);               // w x v
static_assert(VectorProduct<si::angular_acceleration, si::length, si::acceleration>);             // alpha x r
static_assert(VectorProduct<si::length, si::force, si::torque>);                                  // r x F
static_assert(VectorProduct<si::length, si::momentum, si::angular_momentum>);                     // r x p
static_assert(VectorProduct<si::moment_of_inertia, si::angular_velocity, si::angular_momentum>);  // J w
static_assert(VectorProduct<si::moment_of_inertia, si::angular_acceleration, si::torque>);        // J alpha
static_assert(VectorProduct<si::angular_velocity, si::angular_momentum, si::torque>);             // w x H
static_assert(VectorProduct<si::angular_velocity, si::angular_velocity, si::angular_acceleration>);  // w x w
static_assert(VectorProduct<si::angular_velocity, si::time, si::angle>);                             // w t
static_assert(VectorProduct<si::angular_acceleration, si::time, si::angular_velocity>);  // alpha t
static_assert(VectorProduct<si::torque, si::time, si::angular_momentum>);                // tau t
static_assert(VectorProduct<si::force, si::time, si::momentum>);                         // F t
static_assert(VectorProduct<si::mass, si::velocity, si::momentum>);                      // m v
static_assert(VectorProduct<si::mass, si::acceleration, si::force>);                     // m a
static_assert(VectorProduct<si::dimensionless, si::torque, si::torque>);
static_assert(VectorQuotient<si::length, si::time, si::velocity>);                        // dr/dt
static_assert(VectorQuotient<si::velocity, si::time, si::acceleration>);                  // dv/dt
static_assert(VectorQuotient<si::angle, si::time, si::angular_velocity>);                 // dtheta/dt
static_assert(VectorQuotient<si::angular_velocity, si::time, si::angular_acceleration>);  // dw/dt
static_assert(VectorQuotient<si::angular_momentum, si::time, si::torque>);                // dH/dt
static_assert(VectorQuotient<si::momentum, si::time, si::force>);                         // dp/dt
static_assert(VectorQuotient<si::force, si::mass, si::acceleration>);                     // F/m
static_assert(VectorQuotient<si::angular_momentum, si::moment_of_inertia, si::angular_velocity>);
static_assert(VectorQuotient<si::torque, si::moment_of_inertia, si::angular_acceleration>);
static_assert(ScalarProduct<si::torque, si::angular_velocity, si::power>);             // tau . w
static_assert(ScalarProduct<si::force, si::velocity, si::power>);                      // F . v
static_assert(ScalarProduct<si::force, si::length, si::energy>);                       // F . r
static_assert(ScalarProduct<si::angular_momentum, si::angular_velocity, si::energy>);  // H . w
static_assert(!std::same_as<boost_unit<si::torque>, boost_unit<si::energy>>);

static_assert(VectorUnit<si::torque> && VectorUnit<si::angle> && !VectorUnit<si::energy>);
static_assert(!VectorUnit<si::kilometre_unit> && !VectorUnit<si::degree_unit>);

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
}
|| requires(const Left& left, const Right& right) {
  left - right;
};
template <class Left, class Right>
concept Dots = requires(const Left& left, const Right& right) {
  dot(left, right);
};
template <class Left, class Right>
concept Crosses = requires(const Left& left, const Right& right) {
  cross(left, right);
};

using Position = Vector<Body, si::length>;
static_assert(Adds<Position, Position>);
static_assert(!Adds<Position, Vector<Gcrf, si::length>>);
static_assert(!Adds<Position, Vector<Body, si::velocity>>);
static_assert(!Adds<Position, Vector<Gcrf, si::velocity>>);
static_assert(!Adds<Vector<Body, si::torque>, Vector<Body, si::force>>);
static_assert(!Adds<Position, Eigen::Vector3d>);
static_assert(Dots<Position, Vector<Body, si::force>> && Crosses<Position, Vector<Body, si::force>>);
static_assert(!Dots<Position, Vector<Gcrf, si::force>> && !Crosses<Position, Vector<Gcrf, si::force>>);
static_assert(!std::is_convertible_v<Position, Vector<Gcrf, si::length>>);
static_assert(!std::is_convertible_v<Position, Vector<Body, si::velocity>>);
static_assert(!std::is_convertible_v<Eigen::Vector3d, Position>);
static_assert(!std::is_default_constructible_v<Position>);
static_assert(sizeof(Position) == 3 * sizeof(double));

// Which types are frames.
struct Both : inertial_frame, moving_frame {};
struct Neither {};
struct Full : moving_frame {
  double value;
};
static_assert(Frame<Gcrf> && Frame<Wheel<2>> && !Frame<Both> && !Frame<Neither> && !Frame<Full>);
static_assert(!Frame<inertial_frame> && !Frame<moving_frame> && !Frame<double>);
static_assert(InertialFrame<Gcrf> && !InertialFrame<Body>);

template <class Scalar, class V>
concept Scales = requires(Scalar k, V r) {
  k* r;
};
using Axis = Vector<Body, si::dimensionless>;

// A direction takes the unit of the scalar; the radian is not added to it.
static_assert(Scales<Quantity<si::torque>, Axis>);
static_assert(Scales<Quantity<si::angular_velocity>, Axis>);
static_assert(!Scales<Quantity<si::energy>, Axis>);
static_assert(!Scales<Quantity<si::frequency>, Axis>);

}  // namespace
}  // namespace vector_test
