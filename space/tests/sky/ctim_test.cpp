#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include <vectrix/kinematics.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/sky/ephemeris.hpp>

// A cubesat in flight: its own ground processing says which cosines the boresight of its radiometer had to
// the Sun and the Moon. See space/tests/data/ctim_*.csv.
namespace vectrix::ctim_test {
namespace {

using earth::Gcrf;
using earth::Itrf;

struct Ctim : moving_frame {};
struct Radiometer : moving_frame {};

constexpr double arcsecond = 4.84813681109536e-6;  // rad

// The flight's own Sun is geometric. The quaternions are rounded to 1e-4 arcsec, and a kilometre of the place
// is 0.0014 arcsec. The light time alone would be 0.005.
constexpr double sun_tolerance = 0.002 * arcsecond;
// Its Moon is JPL's, from which eraMoon98 is 7.6 arcsec at most.
constexpr double moon_tolerance = 7.6 * arcsecond;
// What aberration would change, of 20 arcsec across the line of sight.
constexpr double seen_otherwise = 5.0 * arcsecond;

const std::filesystem::path data = std::filesystem::path{VECTRIX_SOURCE_DIR} / "space/tests/data";

SampledAttitude<Ctim, Gcrf, Epoch> attitude() {
  const auto table = CsvTable::read(data / "ctim_attitude.csv", {"UTC"});
  std::vector<AttitudeSample<Ctim, Gcrf, Epoch>> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto part = [&](const char* column) { return table.number(i, column) * 5e-10; };
    samples.push_back(
        {Epoch::from_utc(table.text(i, "UTC")),
         nearest_quaternion_scalar_first(to<Ctim>, from<Gcrf>, part("quaternion_c"), part("quaternion_x"),
                                         part("quaternion_y"), part("quaternion_z"))
             .quaternion});
  }
  return {samples, 10.1 * si::second};
}

// The mounting: SPICE's frames map the instrument to the body, v_body = R(q) v_radiometer.
const auto q_ctim_from_radiometer = nearest_quaternion_scalar_first(to<Ctim>, from<Radiometer>, 9.999876e-01,
                                                                    1.534418e-03, 4.728365e-03, -7.255375e-06)
                                        .quaternion;

// The row has the point of the Earth that the boresight meets and the height of the satellite.
Displacement<Gcrf, Ctim, In<Gcrf>> place(const CsvTable& table, std::size_t row, const Dcm<Itrf, Gcrf>& R,
                                         const Vector<Gcrf, si::dimensionless>& boresight) {
  const auto degrees = [&](const char* column) {
    return convert<si::angle>(table.number(row, column) * si::degree);
  };
  const auto ground =
      wgs84::position({GeodeticLatitude(degrees("surfacelat")), degrees("surfacelon"), 0.0 * si::metre});
  const auto ray = R * boresight;
  const auto height = convert<si::length>(table.number(row, "surfacealt") * si::kilometre);
  auto distance = height;
  for (int i = 0; i < 4; ++i) {
    const auto r = ground - distance * ray;
    distance += (height - wgs84::geodetic(r).height) / -dot(wgs84::up(r), ray);
  }
  return displacement(of<Ctim>, relative_to<Gcrf>, inverse(R) * (ground - distance * ray));
}

TEST(Ctim, SawTheGeometricSun) {
  const auto table = CsvTable::read(data / "ctim_pointing.csv", {"timdotsun", "timdotmoon"});
  const auto flown = attitude();
  const auto day = from_until(Epoch::from_utc("2023-04-20T05:00:00"), 3600.0 * si::second);
  const Ephemeris<sky::Sun> sun(day);
  const Ephemeris<sky::Moon> moon(day);
  // finals2000A for this day
  const EarthOrientationParameters earth{convert<si::angle>(0.00575 * si::arcsecond),
                                         convert<si::angle>(0.450431 * si::arcsecond),
                                         (-0.0333569 - 37.0) * si::second,
                                         0.0 * (si::second / si::second),
                                         0.0 * si::radian,
                                         0.0 * si::radian};
  ASSERT_EQ(table.rows(), 7U);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto microseconds = static_cast<std::int64_t>(table.number(row, "microsecondssincegpsepoch"));
    const auto t = Epoch::from_gps_seconds(microseconds / 1'000'000);
    // SPICE's J2000 is GCRF.
    const auto R_ctim_from_gcrf = flown(t).rotation;
    const auto boresight =
        inverse(R_ctim_from_gcrf) * (dcm(q_ctim_from_radiometer) * -unit_z(in<Radiometer>));
    const auto r = place(table, row, inverse(earth_rotation(t, earth).rotation), boresight);
    const auto angle = [&](const auto& line) {
      return std::acos(dot(direction(line.vector()), boresight).value());
    };
    const double to_sun = std::acos(table.number(row, "timdotsun"));
    const double to_moon = std::acos(table.number(row, "timdotmoon"));
    EXPECT_NEAR(angle(sun.line_of_sight(t, r, geometric)), to_sun, sun_tolerance) << "row " << row;
    EXPECT_GT(std::abs(angle(sun.line_of_sight(t, r, light_time)) - to_sun), sun_tolerance);
    EXPECT_NEAR(angle(moon.line_of_sight(t, r, geometric)), to_moon, moon_tolerance) << "row " << row;
    const auto state =
        PointMotion<Gcrf, Ctim, Gcrf>{r, at_rest(of<Ctim>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)};
    EXPECT_GT(std::abs(angle(sun.line_of_sight(t, state, apparent)) - to_sun), seen_otherwise);
  }
}

}  // namespace
}  // namespace vectrix::ctim_test
