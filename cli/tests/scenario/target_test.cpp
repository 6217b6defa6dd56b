#include "target.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "circular_orbit.hpp"
#include "scenario/flight.hpp"
#include "scenario_folder.hpp"

namespace vectrix::cli::scenario_target_test {
namespace {

using earth::Gcrf, earth::Itrf;
using Eigen::Vector3d;

const std::filesystem::path data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";
Epoch at(double seconds) {
  return Epoch::from_utc("2022-04-14T00:00:00") + seconds * si::second;
}

// v_itrf = d/dt r_itrf, by a central difference.
TEST(VelocityInItrf, IsTheDerivativeOfThePositionThere) {
  const auto span = from_until(at(0.0), at(2.0));
  const EarthMotion earth(EarthOrientation::read(data / "finals2000A_april_2022.txt"), span);
  constexpr double h = 0.5, of_the_difference = 1e-7;  // s; rad: h^2 n^2 / 6
  const std::vector<Epoch> times{at(0.0), at(1.0), at(2.0)};
  std::vector<SatelliteMotion> motions;
  for (int i = 0; i < 3; ++i) motions.push_back(circular_orbit<Gcrf>(i));
  const auto found = lines_to(Target::velocity_in_itrf, times, motions, geometric);
  const auto r_itrf = [&](double t) -> Vector3d {
    return (inverse(earth.rotation(at(t))) * circular_orbit<Gcrf>(t).position).coordinates();
  };
  const Vector3d v = (r_itrf(1.0 + h) - r_itrf(1.0 - h)) / (2.0 * h);
  const Vector3d v_gcrf = earth.rotation(at(1.0)).matrix() * v;
  EXPECT_LE(angle_between(found[1], v_gcrf), of_the_difference);
  EXPECT_GT(angle_between(found[1], motions[1].velocity.coordinates()), 0.01);
}

// A flight of two seconds, its body along GCRF.
class MeasuredTarget : public ::testing::Test {
 protected:
  MeasuredTarget()
      : flight{{record(), BodyFrames("body", {})},
               record(),
               record(),
               record().size(),
               [](const Epoch& t) { return circular_orbit<Gcrf>((t - at(0.0)).value()); },
               {},
               {}} {
    scenario.orientation = EarthOrientation::read(data / "finals2000A_april_2022.txt");
    flight.motions = motions_at(flight.attitude.times, flight.orbit);
  }
  static AttitudeRecord record() {
    AttitudeRecord record;
    record.body = "body";
    record.reference = "GCRF";
    record.stated = {Convention::Scalar::first, Convention::Maps::to_body};
    record.times = {at(0.0), at(1.0)};
    record.numbers = {{1.0, 0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    return record;
  }
  [[nodiscard]] Measured found(const MeasureTarget& target,
                               const std::optional<SkyCorrection>& correction = {}) const {
    return measured({{}, "m", {{}, "z of body", "body", Vector3d::UnitZ()}, {}, target, correction}, scenario,
                    flight);
  }
  Scenario scenario;
  Flight flight;
};

TEST_F(MeasuredTarget, IsAStationThatIsBelowWhereTheNormalSaysSo) {
  const EarthMotion earth(*scenario.orientation, from_until(at(0.0), at(1.0)));
  const auto R = earth.rotation(at(0.0));
  const auto r_itrf = (inverse(R) * flight.motions[0].position).vector();
  Geodetic below = wgs84::geodetic(r_itrf);
  below.height = 0.0 * si::metre;
  const auto seen = found(StationTarget{"Station", below});
  const Vector3d down = -(R * wgs84::up(r_itrf)).coordinates();
  constexpr double rounding = 1e-12;
  EXPECT_LE(angle_between(seen.directions[0], down), rounding);
  EXPECT_NEAR(seen.angles[0], angle_between(down, Vector3d::UnitZ()), rounding);
  EXPECT_EQ(seen.what, "angle between z of body and Station");
}

TEST_F(MeasuredTarget, IsAStarAtItsPlaceOrAsItIsSeen) {
  const double a = 1.1, d = -0.3;
  const StarTarget star{"Star", {a * si::radian, d * si::radian}};
  const Vector3d place(std::cos(d) * std::cos(a), std::cos(d) * std::sin(a), std::sin(d));
  constexpr double rounding = 1e-15, arcsecond = 4.848e-6, largest_aberration = 26.0 * arcsecond;
  const auto catalogued = found(star, light_time), seen = found(star, apparent);
  EXPECT_LE((catalogued.directions[1] - place).norm(), rounding);
  EXPECT_LE((seen.directions[1] - place).norm(), largest_aberration);
  EXPECT_GT((seen.directions[1] - place).norm(), arcsecond);
  EXPECT_EQ(seen.what, "angle between z of body and Star, apparent, seen from the satellite");
}

}  // namespace
}  // namespace vectrix::cli::scenario_target_test
