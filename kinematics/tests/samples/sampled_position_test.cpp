#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics/samples/sampled_position.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace sampled_position_test {
namespace {

// Rounding of numbers of about 100.
constexpr double rounding_of_100 = 1e-13;

using Motion = PointMotion<Itrf, Body, Itrf>;

Motion sample(const Eigen::Vector3d& r, const Eigen::Vector3d& v) {
  return point_motion(of<Body>, relative_to<Itrf>, observed_from<Itrf>, vector<si::length>(in<Itrf>, r),
                      vector<si::velocity>(in<Itrf>, v));
}
double error(const Motion& found, const Motion& exact) {
  return detail::larger((found.position.coordinates() - exact.position.coordinates()).norm(),
                        (found.velocity.coordinates() - exact.velocity.coordinates()).norm());
}

// r(t) = (t^3, 1 - t^2, t), which a cubic must reproduce.
Motion cubic(double t) {
  return sample({t * t * t, 1.0 - t * t, t}, {3.0 * t * t, -2.0 * t, 1.0});
}

TEST(Hermite, ReproducesCubics) {
  for (const double t : {0.0, 0.3, 2.0, 3.7, 4.0}) {
    const auto found = hermite(cubic(1.0), cubic(5.0), 4.0 * si::second, t * si::second);
    EXPECT_LT(error(found, cubic(1.0 + t)), rounding_of_100) << t;
  }
}

TEST(Hermite, IsOffACircleByItsFourthDerivative) {
  const auto circle = [](double t) {
    return sample({std::cos(t), std::sin(t), 0.0}, {-std::sin(t), std::cos(t), 0.0});
  };
  const double h = 0.1;
  const auto middle = hermite(circle(0.0), circle(h), h * si::second, 0.5 * h * si::second);
  const double error = (middle.position.coordinates() - circle(0.5 * h).position.coordinates()).norm();
  const double law = std::pow(h, 4) / 384.0;
  const double next_order = 0.01;  // h^2, the relative size of the terms that the law omits
  EXPECT_NEAR(error, law, next_order * law);
}

TEST(Hermite, RefusesTimesOutside) {
  for (const double t : {-0.1, 4.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(hermite(cubic(1.0), cubic(5.0), 4.0 * si::second, t * si::second), BadInput) << t;
  }
  EXPECT_THROW(hermite(cubic(1.0), cubic(5.0), 0.0 * si::second, 0.0 * si::second), BadInput);
  EXPECT_THROW(
      hermite(cubic(1.0), cubic(5.0), std::numeric_limits<double>::infinity() * si::second, 1.0 * si::second),
      BadInput);
}

TEST(Hermite, RefusesADurationTooShortForAVelocity) {
  const auto at = [](double t, double h) {
    return message<BadInput>([&] { (void)hermite(cubic(1.0), cubic(5.0), h * si::second, t * si::second); });
  };
  EXPECT_TRUE(contains(at(5e-321, 1e-320),
                       ": the duration is " + detail::text(1e-320) + " s; the velocity overflows"))
      << at(5e-321, 1e-320);
  EXPECT_EQ(at(5e-301, 1e-300), "");
}

std::vector<PositionSample<Itrf, Body>> cubic_at(const std::vector<double>& times) {
  std::vector<PositionSample<Itrf, Body>> samples;
  for (const double t : times) samples.push_back({t * si::second, cubic(t)});
  return samples;
}

// The position is an edge. Seen from a rotating frame its velocity contains w x r; its axes do not turn.
TEST(SampledPosition, IsAnEdgeThatDoesNotTurn) {
  const auto rate = 0.25 * si::radian / si::second;
  const auto turning = edge([=](Quantity<si::time> t) {
    return moving_dcm(turned_z(to<Gcrf>, from<Itrf>, Quantity<si::angle>(-rate * t)),
                      angular_velocity(of<Itrf>, relative_to<Gcrf>, rate * unit_z(in<Itrf>)));
  });
  const auto graph = frame_graph(turning, sampled_edge(cubic_at({0, 1, 2, 5}), 3.0 * si::second));
  for (const double t : {0.0, 0.3, 1.0, 4.0, 5.0}) {
    const auto now = graph.at(t * si::second);
    EXPECT_LT(
        (now.position(of<Body>, relative_to<Itrf>, in<Itrf>).coordinates() - cubic(t).position.coordinates())
            .norm(),
        rounding_of_100);
    const Eigen::Vector3d w(0.0, 0.0, 0.25);
    const Eigen::Vector3d expected =
        cubic(t).velocity.coordinates() + w.cross(cubic(t).position.coordinates());
    EXPECT_LT(
        (now.velocity(of<Body>, relative_to<Itrf>, observed_from<Gcrf>, in<Itrf>).coordinates() - expected)
            .norm(),
        rounding_of_100);
    EXPECT_EQ(now.rotation(to<Itrf>, from<Body>).matrix(), Eigen::Matrix3d::Identity());
    EXPECT_EQ(now.angular_velocity(of<Body>, relative_to<Itrf>, in<Body>).coordinates(),
              Eigen::Vector3d::Zero());
  }
}

TEST(SampledPosition, OutsideAndInAGapIsRefused) {
  const SampledPosition position(cubic_at({0, 1, 2, 7}), 2.0 * si::second);
  const auto said = [&](double t) { return message<BadInput>([&] { position(t * si::second); }); };
  const std::string place = detail::samples_place<Itrf, Body>("SampledPosition") + ": ";
  EXPECT_EQ(said(7.5), place + "the time 7.5 s is outside the samples, [0 s, 7 s]");
  EXPECT_EQ(said(3),
            place + "the time 3 s is in a gap of 5 s after the sample at 2 s; the longest allowed is 2 s");
  EXPECT_EQ(said(2) + said(0.5), "");
}

}  // namespace
}  // namespace sampled_position_test
