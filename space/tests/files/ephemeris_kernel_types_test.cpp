#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "files/ephemeris_kernels.hpp"

// What the types of segments say between their numbers, and how segments are put together.
namespace vectrix::ephemeris_kernel_test {
namespace {

struct SunInertial : inertial_frame {};
struct Ecliptic : inertial_frame {};

TEST(EphemerisKernel, OfEachTypeIsExactForACubic) {
  for (const int type : {2, 3, 8, 9, 12, 13}) {
    for (const bool big : {false, true}) {
      const auto kernel = written({of_type(type)}, big);
      const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"));
      const auto part = kernel.motion(of<Ship>, relative_to<Gcrf>,
                                      from_until(at_seconds(400.0), at_seconds(420.0)), called<Ship>("-77"));
      for (const double t : {100.1, 125.0, 149.9, 410.0, 777.0, 1099.0}) {
        const auto now = orbit.at(at_seconds(t));
        EXPECT_LT((now.position.coordinates() - km * cubic(t, 0)).norm(), of_time) << type << " " << t;
        EXPECT_LT((now.velocity.coordinates() - km * cubic(t, 1)).norm(), of_time_in_velocity)
            << type << " " << t;
      }
      EXPECT_EQ(part.at(at_seconds(410.0)).position.coordinates(),
                orbit.at(at_seconds(410.0)).position.coordinates());
      EXPECT_THROW(static_cast<void>(part.at(at_seconds(421.0))), BadInput);
      EXPECT_THROW(static_cast<void>(orbit.at(at_seconds(99.0))), BadInput);
      EXPECT_THROW(static_cast<void>(orbit.at(kernel.span().end() + 1.0 * si::second)), BadInput);
    }
  }
}

TEST(EphemerisKernel, TakesTheStatesAroundTheInstant) {
  // x alone is 1 at the fourth of eight states, and 0 at the others: the value says which states were taken.
  const auto at = [](int type, double window, double t) {
    std::vector<double> numbers;
    for (int i = 0; i < 8; ++i) numbers.insert(numbers.end(), {i == 3 ? 1.0 : 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
    if (type == 8) numbers.insert(numbers.end(), {0.0, 1000.0});
    if (type == 9) {
      for (int i = 0; i < 8; ++i) numbers.push_back(1000.0 * i);
    }
    numbers.insert(numbers.end(), {window, 8.0});
    const auto kernel = written({segment(type, numbers, 0.0, 7000.0)});
    const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"));
    return orbit.at(at_seconds(t)).position.coordinates().x() / km;
  };
  constexpr double of_time_per_step = 1e-6;
  for (const int type : {8, 9}) {
    // Two states: a straight line from one to the next.
    EXPECT_NEAR(at(type, 1.0, 2250.0), 0.25, of_time_per_step);
    EXPECT_NEAR(at(type, 1.0, 3250.0), 0.75, of_time_per_step);
    EXPECT_NEAR(at(type, 1.0, 4250.0), 0.0, of_time_per_step);
    // Three: the nearest one and its neighbours. At 2.6 that is the fourth, at 2.4 the third.
    EXPECT_NEAR(at(type, 2.0, 2600.0), 1.0 - 0.4 * 0.4, of_time_per_step);
    EXPECT_NEAR(at(type, 2.0, 2400.0), 0.4 * 1.4 / 2.0, of_time_per_step);
    // Four: two on each side.
    EXPECT_NEAR(at(type, 3.0, 4500.0), -1.0 / 16.0, of_time_per_step);
    EXPECT_NEAR(at(type, 3.0, 3500.0), 9.0 / 16.0, of_time_per_step);
    // At an end the first ones.
    EXPECT_NEAR(at(type, 3.0, 500.0), 1.0 / 16.0, of_time_per_step);
  }
}

TEST(EphemerisKernel, IsAnEdge) {
  const auto kernel = written({of_type(13)});
  const auto graph =
      frame_graph(edge(kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"))));
  const auto now = graph.at(at_seconds(500.0));
  EXPECT_LT((now.position(of<Ship>, relative_to<Gcrf>, in<Gcrf>).coordinates() - km * cubic(500.0, 0)).norm(),
            of_time);
}

TEST(EphemerisKernel, AddsSegmentsUp) {
  // As in a kernel of planets: the Moon and the Earth relative to their barycentre, that and the Sun to the
  // barycentre of the solar system.
  const auto kernel = written({of_type(2, 301, 3), of_type(2, 399, 3, 1, -2.0), of_type(2, 3, 0, 1, 10.0),
                               of_type(2, 10, 0, 1, 0.5)});
  const Epoch t = at_seconds(500.0);
  const Eigen::Vector3d r = km * cubic(500.0, 0), v = km * cubic(500.0, 1);
  const auto moon = kernel.motion(of<sky::Moon>, relative_to<Gcrf>, kernel.span()).at(t);
  EXPECT_LT((moon.position.coordinates() - 3.0 * r).norm(), 20.0 * of_time);
  const auto sun = kernel.motion(of<sky::Sun>, relative_to<Gcrf>, kernel.span()).at(t);
  EXPECT_LT((sun.position.coordinates() - (0.5 - (10.0 - 2.0)) * r).norm(), 20.0 * of_time);
  EXPECT_LT((sun.velocity.coordinates() - (0.5 - (10.0 - 2.0)) * v).norm(), 20.0 * of_time_in_velocity);
  const auto moon_of_sun =
      kernel
          .motion(of<sky::Moon>, relative_to<SunInertial>, kernel.span(), called<SunInertial>("J2000", "SUN"))
          .at(t);
  EXPECT_LT((moon_of_sun.position.coordinates() - (1.0 + 10.0 - 0.5) * r).norm(), 20.0 * of_time);
}

TEST(EphemerisKernel, TurnsFromTheEclipticOfJ2000) {
  const auto kernel = written({of_type(2, -77, 399, 17)});
  const Epoch t = at_seconds(500.0);
  const auto equator = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77")).at(t);
  const auto ecliptic = kernel
                            .motion(of<Ship>, relative_to<Ecliptic>, kernel.span(), called<Ship>("-77"),
                                    called<Ecliptic>("ECLIPJ2000"))
                            .at(t);
  const Eigen::Vector3d r = km * cubic(500.0, 0);
  EXPECT_LT((ecliptic.position.coordinates() - r).norm(), of_time);
  // The pole of the ecliptic is towards -y of the equator.
  constexpr double e = 84381.448 / 3600.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d expected(r.x(), std::cos(e) * r.y() - std::sin(e) * r.z(),
                                 std::sin(e) * r.y() + std::cos(e) * r.z());
  EXPECT_LT((equator.position.coordinates() - expected).norm(), of_time);
}

TEST(EphemerisKernel, TheLastSegmentThatKnowsAnInstantCounts) {
  auto narrow = of_type(9, -77, 399, 1, 2.0);
  narrow.doubles = {300.0, 400.0};
  for (const bool narrow_is_last : {true, false}) {
    const auto wide = of_type(2);
    const auto kernel = narrow_is_last ? written({wide, narrow}) : written({narrow, wide});
    const auto orbit = kernel.motion(of<Ship>, relative_to<Gcrf>, kernel.span(), called<Ship>("-77"));
    for (const double t : {200.0, 350.0, 500.0}) {
      const double sign = narrow_is_last && t == 350.0 ? 2.0 : 1.0;
      EXPECT_LT((orbit.at(at_seconds(t)).position.coordinates() - sign * km * cubic(t, 0)).norm(),
                2.0 * of_time)
          << t;
    }
  }
}

}  // namespace
}  // namespace vectrix::ephemeris_kernel_test
