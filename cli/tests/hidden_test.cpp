#include "hidden.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "circular_orbit.hpp"
#include "sunlight.hpp"

namespace vectrix::cli::hidden_test {
namespace {

using earth::Gcrf, earth::Itrf;
using Eigen::Vector3d;

const Epoch start = Epoch::from_utc("2023-04-20T05:00:00");
constexpr double degree = std::numbers::pi / 180.0;
constexpr double equatorial = 6378137.0, polar = 6356752.314245;

SatelliteMotion at_rest_at(const Vector3d& r) {
  return point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>, vector<si::length>(in<Gcrf>, r),
                      vector<si::velocity>(in<Gcrf>, Vector3d::Zero()));
}
EarthOrientation unobserved() {
  return EarthOrientation::unobserved(from_until(start, start + 60.0 * si::second), 0.0 * si::second);
}
bool is_hidden(const MeasureTarget& target, const Vector3d& satellite, const Vector3d& line) {
  return hidden_by_earth(target, {start, start + 60.0 * si::second},
                         {at_rest_at(satellite), at_rest_at(satellite)}, true, {line, line}, unobserved())
      .front();
}

// The tangent from (r, 0) to an ellipse with the half axes a and b leaves its axis at an angle of tangent
// b/sqrt(r^2 - a^2). The pole is within 0.15 deg of z, which moves the limb by less than 0.01 deg.
TEST(Hidden, AStarIsBehindTheLimbOfTheEllipsoid) {
  constexpr double r = 7e6, beside = 0.02 * degree;
  const StarTarget star{"Star", {}};
  const auto hidden = [&](double angle, const Vector3d& side) {
    return is_hidden(star, {r, 0.0, 0.0}, -std::cos(angle) * Vector3d::UnitX() + std::sin(angle) * side);
  };
  const double root = std::sqrt(r * r - equatorial * equatorial);
  const double to_equator = std::atan(equatorial / root), to_pole = std::atan(polar / root);
  ASSERT_GT(to_equator - to_pole, 2.0 * beside);
  EXPECT_TRUE(hidden(to_equator - beside, Vector3d::UnitY()));
  EXPECT_FALSE(hidden(to_equator + beside, Vector3d::UnitY()));
  EXPECT_TRUE(hidden(to_pole - beside, Vector3d::UnitZ()));
  EXPECT_FALSE(hidden(to_pole + beside, Vector3d::UnitZ()));
  EXPECT_FALSE(hidden(std::numbers::pi, Vector3d::UnitY())) << "above";
}

// At an elevation of 0.01 deg it is seen, and at -0.01 deg it is hidden, whatever the height of the place.
TEST(Hidden, AStationIsBelowItsHorizon) {
  const EarthMotion earth(unobserved(), from_until(start, start + 60.0 * si::second));
  struct Site : east_north_up_frame {};
  for (const double height : {-400.0, 0.0, 5000.0}) {
    const StationTarget station{"Station",
                                {GeodeticLatitude(0.7 * si::radian), -1.9 * si::radian, height * si::metre}};
    const Vector3d place = wgs84::position(station.at).coordinates();
    for (const double azimuth : {0.3, 2.0, 4.0}) {
      for (const double elevation : {-60.0, -0.01, 0.01, 90.0}) {
        const double a = azimuth, e = elevation * degree;
        const Vector3d east(-std::sin(-1.9), std::cos(-1.9), 0.0),
            up(std::cos(0.7) * std::cos(-1.9), std::cos(0.7) * std::sin(-1.9), std::sin(0.7)),
            north = up.cross(east);
        const Vector3d satellite =
            place + 2e6 * (std::cos(e) * (std::sin(a) * east + std::cos(a) * north) + std::sin(e) * up);
        const Eigen::Matrix3d R_gcrf_from_itrf = earth.rotation(start).matrix();
        const Vector3d r = R_gcrf_from_itrf * satellite, line = R_gcrf_from_itrf * (place - satellite);
        EXPECT_EQ(is_hidden(station, r, line), elevation < 0.0)
            << height << ' ' << azimuth << ' ' << elevation;
      }
    }
  }
}

// The centre of the Sun is hidden where less than half of its disc is seen.
TEST(Hidden, TheSunIsWhereMostOfItsDiscIs) {
  std::vector<Epoch> times;
  std::vector<SatelliteMotion> motions;
  for (double s = 0.0; s < 5900.0; s += 10.0) {
    times.push_back(start + s * si::second);
    motions.push_back(circular_orbit<Gcrf>(s));
  }
  const auto hidden = hidden_by_earth(Target::sun, times, motions, true,
                                      lines_to(Target::sun, times, motions, geometric), {});
  const auto seen = visible_suns(times, motions);
  std::size_t count = 0;
  ASSERT_EQ(hidden.size(), seen.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    constexpr double near_half = 0.05;  // the limb is curved
    if (std::abs(seen[i] - 0.5) > near_half) {
      EXPECT_EQ(hidden[i], seen[i] < 0.5) << i << ' ' << seen[i];
    }
    count += hidden[i] ? 1U : 0U;
  }
  EXPECT_GT(count, 100U);
  EXPECT_LT(count, times.size() - 100U);
  EXPECT_EQ(words_of_hidden(hidden, "sample"), "the Earth hides it at " + std::to_string(count) + " of " +
                                                   std::to_string(times.size()) + " samples");
}

TEST(Hidden, OthersAreNot) {
  const std::vector<Epoch> times{start, start + 60.0 * si::second};
  const std::vector<SatelliteMotion> motions{circular_orbit<Gcrf>(0.0), circular_orbit<Gcrf>(60.0)};
  for (const Target target : {Target::earth, Target::velocity, Target::velocity_in_itrf}) {
    EXPECT_FALSE(may_be_hidden(target));
    EXPECT_TRUE(hidden_by_earth(target, times, motions, true, lines_to(target, times, motions, geometric), {})
                    .empty());
  }
  EXPECT_TRUE(hidden_by_earth(Target::sun, times, motions, false,
                              lines_to(Target::sun, times, motions, geometric), {})
                  .empty())
      << "without an orbit";
  EXPECT_EQ(words_of_hidden({false, false}, "sample"), "");
}

}  // namespace
}  // namespace vectrix::cli::hidden_test
