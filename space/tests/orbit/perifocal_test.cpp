#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <vectrix/space/orbit/perifocal.hpp>

#include "testing/attitudes.hpp"
#include "testing/motions.hpp"

namespace vectrix::perifocal_test {
namespace {

using Eigen::Vector3d;
using vectrix_test::Dual2, vectrix_test::constant, vectrix_test::instant, vectrix_test::message;

struct Gcrf : inertial_frame {};
struct Ship : moving_frame {};
struct Pqw : moving_frame {};

using Motion = PointMotion<Gcrf, Ship, Gcrf>;
using Elements = KeplerianElements<Gcrf, Ship, Gcrf>;

// Numbers of size 1, so that mu = 1 gives every kind of conic.
const auto mu = Quantity<si::gravitational_parameter>::from_value(1.0);
constexpr double rounding = 1e-15;  // of a unit vector made of some ten products of numbers of size 1

template <class S>
PointMotion<Gcrf, Ship, Gcrf, S> motion_of(const Eigen::Matrix<S, 3, 1>& r, const Eigen::Matrix<S, 3, 1>& v) {
  return point_motion(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, v));
}
Elements elements_of(double e, double i, double node, double w, double nu) {
  return keplerian_elements(of<Ship>, relative_to<Gcrf>, in<Gcrf>, 1.5 * si::metre, e, i * si::radian,
                            node * si::radian, w * si::radian, TrueAnomaly{nu * si::radian});
}

// The conic in its plane, p/(1 + e cos nu) (cos nu, sin nu, 0) and sqrt(mu/p) (-sin nu, e + cos nu, 0):
// written down here, so that a transposed or reflected frame is found.
TEST(Perifocal, MotionInItsAxesIsTheConic) {
  std::mt19937_64 random(20270501);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  constexpr double pi = std::numbers::pi, p = 1.5;
  for (int i = 0; i < 300; ++i) {
    const double e = 0.05 + 2.0 * number(random);
    const double nu = (e < 1.0 ? 1.0 : 0.9 * std::acos(-1.0 / e) / pi) * pi * (2.0 * number(random) - 1.0);
    const auto elements = elements_of(e, pi * number(random), 2.0 * pi * number(random) - pi,
                                      2.0 * pi * number(random) - pi, nu);
    const Motion motion = point_motion(mu, elements);
    const double r = p / (1.0 + e * std::cos(nu)), speed = std::sqrt(mu.value() / p);
    const Vector3d position = r * Vector3d(std::cos(nu), std::sin(nu), 0.0),
                   velocity = speed * Vector3d(-std::sin(nu), e + std::cos(nu), 0.0);
    // e = v x h/mu - r/|r| and h cancel to e and to the sine of the angle between r and v, and each size
    // amplifies the rounding of the terms.
    const double sine = position.cross(velocity).norm() / (position.norm() * velocity.norm());
    const double terms = std::max(1.0, position.norm() * velocity.squaredNorm());
    const double tolerance = 4.0 * rounding * terms / (std::min(e, 1.0) * sine);
    for (const Dcm<Gcrf, Pqw>& R : {perifocal(from<Pqw>, elements), perifocal(from<Pqw>, mu, motion)}) {
      EXPECT_LE(((inverse(R) * motion.position).coordinates() - position).norm(), tolerance * position.norm())
          << "e = " << e;
      EXPECT_LE(((inverse(R) * motion.velocity).coordinates() - velocity).norm(), tolerance * velocity.norm())
          << "e = " << e;
    }
  }
}

// The frame of elements takes every degenerate case: axes that are exact.
TEST(Perifocal, ElementsOfACircleInThePlaneOfXAndY) {
  const Dcm<Gcrf, Pqw> R = perifocal(from<Pqw>, elements_of(0.0, 0.0, 0.0, 0.0, 1.0));
  EXPECT_EQ((R.matrix() - Eigen::Matrix3d::Identity()).norm(), 0.0);
}

// Two bodies alone: the axes rest.
TEST(Perifocal, OfTwoBodiesItRests) {
  const Motion motion = point_motion(mu, elements_of(0.4, 1.0, 0.5, -2.0, 1.2));
  const auto moving =
      perifocal(from<Pqw>, mu, motion, two_body_acceleration(mu, motion.position), two_body_jerk(mu, motion));
  static_assert(std::same_as<decltype(moving), const AcceleratingDcm<Gcrf, Pqw>>);
  EXPECT_LE(moving.angular_velocity.coordinates().norm(), 10 * rounding);
  EXPECT_LE(moving.angular_acceleration.coordinates().norm(), 10 * rounding);
}

// A path with any derivatives: the rates come from automatic differentiation of the matrix. Numbers of size
// 1, sin(r, v) and e at least 0.3: acceleration terms reach 1e3, and the rounding grows by 1/(e sin)^2.
TEST(Perifocal, RateAndAccelerationAreDerivativesOfTheRotation) {
  constexpr double rate_tolerance = 1e-13, acceleration_tolerance = 1e-11;
  std::mt19937_64 random(20270502);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const Dual2 t = instant(0.0);
  int seen = 0;
  for (int i = 0; i < 400; ++i) {
    Vector3d path[4];
    for (Vector3d& x : path) x = {number(random), number(random), number(random)};
    const Motion now = motion_of<double>(path[0], path[1]);
    if (distance_from_singularity(now).value() < 0.3 || path[0].norm() < 0.3 ||
        keplerian_elements(mu, now).eccentricity() < 0.3)
      continue;
    ++seen;
    Eigen::Matrix<Dual2, 3, 1> r, v;
    for (int k = 0; k < 3; ++k) {
      const Dual2 x = constant(path[0](k)), xdot = constant(path[1](k)), half = constant(path[2](k) / 2),
                  sixth = constant(path[3](k) / 6);
      r(k) = x + t * (xdot + t * (half + t * sixth));
      v(k) = xdot + t * (constant(2) * half + constant(3) * t * sixth);
    }
    const vectrix_test::Motion<Gcrf, Pqw> exact(
        perifocal(from<Pqw>, Quantity<si::gravitational_parameter, Dual2>::from_value(constant(1.0)),
                  motion_of<Dual2>(r, v)));
    const auto a = acceleration(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>,
                                vector<si::acceleration>(in<Gcrf>, path[2]));
    const auto jerk = derivative<si::acceleration>(observed_from<Gcrf>, vector<si::jerk>(in<Gcrf>, path[3]));
    const AcceleratingDcm<Gcrf, Pqw> frame = perifocal(from<Pqw>, mu, now, a, jerk);
    EXPECT_LE((frame.rotation.matrix() - exact.R).norm(), 40 * rounding);
    EXPECT_LE((frame.angular_velocity.coordinates() - exact.w_ab_b().coordinates()).norm(), rate_tolerance);
    EXPECT_LE((frame.angular_acceleration.coordinates() - exact.alpha_ab_b().coordinates()).norm(),
              acceleration_tolerance);
    const MovingDcm<Gcrf, Pqw> slower = perifocal(from<Pqw>, mu, now, a);
    EXPECT_EQ(slower.angular_velocity.coordinates(), frame.angular_velocity.coordinates());
  }
  EXPECT_GT(seen, 100);
}

TEST(Perifocal, RefusesCirclesLinesAndAttraction) {
  const auto refused = [](const Quantity<si::gravitational_parameter>& attraction, const Vector3d& r,
                          const Vector3d& v) {
    return message<BadInput>([&] { perifocal(from<Pqw>, attraction, motion_of<double>(r, v)); });
  };
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY();
  const auto place = [](const std::string& reason) {
    return "perifocal(from<" + frame_name<Pqw>() + ">, " + frame_name<Ship>() + " relative to " +
           frame_name<Gcrf>() + "): " + reason;
  };
  EXPECT_EQ(refused(mu, x, y), place("the eccentricity is 0; a circle has no periapsis"));
  EXPECT_EQ(refused(-1.0 * mu, x, y), place("mu is -1 m^3/s^2; it must be positive and finite"));
  EXPECT_NE(refused(mu, x, 2.0 * x).find("rectilinear motion has no orbital plane"), std::string::npos);
  EXPECT_NE(refused(mu, x, Vector3d::Zero()).find("rectilinear motion has no orbital plane"),
            std::string::npos);
  EXPECT_EQ(refused(1e-320 * mu, x, y),
            place("with mu " + detail::text((1e-320 * mu).value()) +
                  " m^3/s^2 the eccentricity or a derivative of it is not finite"));
  const auto strong = acceleration(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>,
                                   vector<si::acceleration>(in<Gcrf>, Vector3d(1e300, 1e300, 0.0)));
  const auto motion = motion_of<double>(1e10 * x, 1.5 * y);
  EXPECT_EQ(message<BadInput>([&] { perifocal(from<Pqw>, mu, motion, strong); }),
            place("with mu 1 m^3/s^2 the eccentricity or a derivative of it is not finite"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused(nan * mu, x, y), place("mu is nan m^3/s^2; it must be positive and finite"));
}

}  // namespace
}  // namespace vectrix::perifocal_test
