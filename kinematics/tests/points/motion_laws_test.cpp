#include <gtest/gtest.h>

#include <vectrix/kinematics.hpp>
#include <vectrix/kinematics/points/motion_laws.hpp>

#include "testing/attitudes.hpp"

// The moving edges of the library satisfy the laws of motion. Each mistake is reported by the law that it
// violates.
using namespace vectrix;
using namespace vectrix_test;

namespace motion_laws_test {
namespace {

using Eigen::Vector3d;

Quantity<si::time> seconds(double t) {
  return t * si::second;
}
const auto now = seconds(0.7);
const auto step = seconds(1e-3);

// Two rotations about different axes, and a position on a circle: R, w, alpha, r, v and a in closed form.
Dcm<Gcrf, Body> attitude(double t) {
  return inverse(turned_x(to<Body>, from<Camera>, 0.4 * t * si::radian) *
                 turned_z(to<Camera>, from<Gcrf>, 0.3 * t * t * si::radian));
}
Vector3d rate(double t) {
  const double c = std::cos(0.4 * t), s = std::sin(0.4 * t);
  return {0.4, 0.6 * t * s, 0.6 * t * c};
}
Vector3d acceleration(double t) {
  const double c = std::cos(0.4 * t), s = std::sin(0.4 * t);
  return {0.0, 0.6 * s + 0.24 * t * c, 0.6 * c - 0.24 * t * s};
}
AcceleratingDcm<Gcrf, Body> turning(double t, const Vector3d& w, const Vector3d& alpha) {
  return accelerating_dcm(
      attitude(t), angular_velocity(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Body>, w)),
      angular_acceleration(of<Body>, relative_to<Gcrf>, vector<si::angular_acceleration>(in<Body>, alpha)));
}
AcceleratingTransform<Gcrf, Body> moving(double t, double velocity_factor, double acceleration_factor) {
  const Vector3d r(std::cos(t), std::sin(t), t * t), v(-std::sin(t), std::cos(t), 2 * t);
  const Vector3d a(-std::cos(t), -std::sin(t), 2);
  return {turning(t, rate(t), acceleration(t)),
          displacement(of<Body>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r)),
          velocity(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>,
                   vector<si::velocity>(in<Gcrf>, velocity_factor * v)),
          vectrix::acceleration(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>,
                                vector<si::acceleration>(in<Gcrf>, acceleration_factor * a))};
}

template <class F> std::string said(const F& f) {
  return message<BadInput>([&] { require_motion_laws(f, now, step); });
}
std::string said_of_turning(const std::function<Vector3d(double)>& w,
                            const std::function<Vector3d(double)>& alpha) {
  return said([&](Quantity<si::time> t) { return turning(t.value(), w(t.value()), alpha(t.value())); });
}

TEST(MotionLaws, AreKeptInClosedForm) {
  EXPECT_EQ(said([](Quantity<si::time> t) { return attitude(t.value()); }), "");
  EXPECT_EQ(said_of_turning(rate, acceleration), "");
  EXPECT_EQ(said([](Quantity<si::time> t) { return moving(t.value(), 1, 1); }), "");
  EXPECT_EQ(said([](Quantity<si::time>) { return rigid_edge(attitude(0.2)).value(); }), "");
}

TEST(MotionLaws, AreKeptBySplines) {
  std::vector<AttitudeSample<Gcrf, Body>> samples;
  for (const double t : {0.0, 0.5, 1.0, 1.5}) samples.push_back({seconds(t), quaternion(attitude(t))});
  EXPECT_EQ(said(RotationSpline(samples, seconds(1.0), natural_ends)), "");
  EXPECT_EQ(said(SampledAttitude(samples, seconds(1.0))), "");
}

TEST(MotionLaws, TellWhichIsBroken) {
  const auto in_reference = [](double t) -> Vector3d { return attitude(t).matrix() * rate(t); };
  EXPECT_TRUE(contains(said_of_turning(in_reference, acceleration),
                       "at 0.7 s is not the derivative of its rotation: it is off by"));
  EXPECT_TRUE(
      contains(said_of_turning([](double t) -> Vector3d { return -rate(t); }, acceleration), "the rate of "));
  EXPECT_TRUE(contains(said_of_turning([](double) -> Vector3d { return Vector3d::Zero(); }, acceleration),
                       ", 1 of the larger of the two"));
  EXPECT_TRUE(contains(said_of_turning(rate, [](double) -> Vector3d { return Vector3d::Zero(); }),
                       "the angular acceleration of "));
  EXPECT_TRUE(
      contains(said([](Quantity<si::time> t) { return moving(t.value(), 1.001, 1); }), "the velocity of "));
  EXPECT_TRUE(
      contains(said([](Quantity<si::time> t) { return moving(t.value(), 1, 0); }), "the acceleration of "));
  EXPECT_TRUE(contains(said([](Quantity<si::time>) {
                         return trust_dcm(to<Gcrf>, from<Body>, Eigen::Matrix3d::Identity() * 1.001);
                       }),
                       "is none: R^T R differs from I by 0.002"));
  EXPECT_TRUE(contains(said_of_turning(rate, [](double t) -> Vector3d { return 1.001 * acceleration(t); }),
                       "the angular acceleration of "));
  EXPECT_TRUE(contains(said([](Quantity<si::time> t) { return moving(t.value(), 1, 1.001); }),
                       "the acceleration of "));
  for (int entry = 0; entry < 9; ++entry) {
    Eigen::Matrix3d bad = Eigen::Matrix3d::Identity();
    bad(entry) = std::nan("");
    EXPECT_TRUE(
        contains(said([&](Quantity<si::time>) { return trust_dcm(to<Gcrf>, from<Body>, bad); }), "nan"))
        << entry;
  }
  EXPECT_EQ(message<BadInput>([&] {
              require_motion_laws([](Quantity<si::time>) { return attitude(0); }, now, seconds(0));
            }),
            "require_motion_laws: the step is 0 s");
}

}  // namespace
}  // namespace motion_laws_test
