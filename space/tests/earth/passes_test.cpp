#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/points/rigid_edge.hpp>
#include <vectrix/space/earth/look_angles.hpp>
#include <vectrix/space/time/events.hpp>

namespace vectrix::passes_test {
namespace {

using earth::Itrf;

struct Station : east_north_up_frame {};
struct Satellite : moving_frame {};

constexpr double pi = std::numbers::pi;
constexpr double found_to = 1e-9 + 4e-11;  // s: the tolerance of events, and the rounding of the clock
// A rounding of the position, 1e-9 m, moves the elevation by 1e-15 rad, and the satellite sinks by 1e-4
// rad/s.
constexpr double epoch_rounding = 2e-11;      // s
constexpr double elevation_rounding = 2e-15;  // rad

// A circle above the equator, in the rotating Earth, over a station on the equator. It is seen above the
// elevation E while the angle at the centre of the Earth is less than acos(a cos E / r) - E.
TEST(Passes, OfACircleAboveTheEquator) {
  constexpr double r = 7.0e6, a = 6378137.0, rate = 1e-3, least = 5.0 * pi / 180.0;  // m, m, rad/s, rad
  const Epoch start = Epoch::from(scale::tai, "2022-04-14T00:00:00");
  constexpr double first_culmination = 1234.5;  // s
  const auto angle = [&](const Epoch& t) { return rate * ((t - start).value() - first_culmination); };
  const Geodetic place{GeodeticLatitude(0.0 * si::radian), 0.0 * si::radian, 0.0 * si::metre};
  const auto graph = frame_graph(
      rigid_edge(east_north_up(from<Station>, place)), edge([&](const Epoch& t) {
        const double at = angle(t);
        return Transform{aligned(to<Itrf>, from<Satellite>),
                         displacement(of<Satellite>, relative_to<Itrf>,
                                      vector<si::length>(in<Itrf>, Eigen::Vector3d(r * std::cos(at),
                                                                                   r * std::sin(at), 0.0)))};
      }));
  const auto look = [&](const Epoch& t) {
    return look_angles(graph.at(t).position(of<Satellite>, relative_to<Station>, in<Station>));
  };
  const auto passes = intervals(from_until(start, 86400.0 * si::second), 100.0 * si::second,
                                [&](const Epoch& t) { return look(t).elevation - least * si::radian; });

  const double half = (std::acos(a * std::cos(least) / r) - least) / rate;  // s
  ASSERT_EQ(passes.size(), 14U);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const double culmination = first_culmination + static_cast<double>(i) * 2 * pi / rate;
    EXPECT_NEAR((passes[i].start() - start).value(), culmination - half, found_to + epoch_rounding);
    EXPECT_NEAR((passes[i].end() - start).value(), culmination + half, found_to + epoch_rounding);
    // It rises in the west and sets in the east.
    EXPECT_NEAR(look(passes[i].start()).azimuth.value(), 3 * pi / 2, elevation_rounding);
    EXPECT_NEAR(look(passes[i].end()).azimuth.value(), pi / 2, elevation_rounding);
  }
}

}  // namespace
}  // namespace vectrix::passes_test
