// Did the cubesat's radiometer look at the Sun? Two hours of CTIM, from its telemetry, its mounting and its
// orbit.
//
//     Satellite --- Teme --- Itrf --- Gcrf --- Body --- Radiometer
//
//     r^teme, v^teme      SGP4 from two-line elements; the axes of Satellite are those of Teme
//     R_itrf^teme, w      sidereal time of 1982 and the observed pole: the Earth as SGP4 sees it
//     R_itrf^gcrf, w      IAU 2006/2000A, observed by the IERS
//     R_gcrf^body         quaternions each 10 s, scalar first, of norm 2e9; between two the rate is constant
//     R_radiometer^body   the mounting, a quaternion
//
// The instrument looks along -z of the radiometer. Every figure is an angle between that axis and a body of
// the sky, both in Gcrf:
//     cos a = (-z^gcrf) . s^gcrf,    -z^gcrf = R_body^gcrf R_radiometer^body (0, 0, -1)
//
// The flight's own ground processing has published these cosines. Neither its code nor its ephemerides are
// used here. What differs if one link is taken otherwise:
//     the Sun as it is seen, apparent, not where it is: 12.9 arcsec rms     so its Sun is geometric
//     the Sun from the centre of the Earth: 4.5 arcsec rms                  so its Sun has the parallax
//     the mounting the other way round: up to 1.1 deg, twice its 0.57 deg
//
// Expected results: the Sun to some hundredths of an arcsecond, what is left of a printed cosine near 1; the
// Moon to some arcseconds, the accuracy of ERFA's eraMoon98.
//
//     radiometer_on_sun [data directory]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <vector>

#include <vectrix/space.hpp>

#ifndef VECTRIX_EXAMPLE_DATA
#define VECTRIX_EXAMPLE_DATA "examples/data"
#endif

namespace {

using namespace vectrix;
using earth::Gcrf, earth::Itrf, earth::Teme;

struct Satellite : moving_frame {};
struct Body : moving_frame {};
struct Radiometer : moving_frame {};

using Attitude = AttitudeSample<Body, Gcrf, Epoch>;

// v_body = R(q) v_gcrf: the quaternion takes coordinates from Gcrf to the body.
std::vector<Attitude> read_attitude(const std::filesystem::path& file) {
  constexpr double scale = 5e-10;  // the file has whole numbers
  const auto table =
      CsvTable::read(file, {"UTC", "quaternion_c", "quaternion_x", "quaternion_y", "quaternion_z"});
  std::vector<Attitude> samples;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto q = [&](const char* column) { return scale * table.number(i, column); };
    samples.push_back(
        {table.value(i, "UTC", Epoch::from_utc),
         nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, q("quaternion_c"), q("quaternion_x"),
                                         q("quaternion_y"), q("quaternion_z"))
             .quaternion});
  }
  return samples;
}

// One row of the flight's own results: the cosines of the boresight to Sun and Moon.
struct Published {
  Epoch epoch;
  double cosine_sun, cosine_moon;
};

std::vector<Published> read_pointing(const std::filesystem::path& file) {
  const auto table = CsvTable::read(file, {"microsecondssincegpsepoch", "timdotmoon", "timdotsun"});
  std::vector<Published> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto microseconds = static_cast<std::int64_t>(table.number(i, "microsecondssincegpsepoch"));
    rows.push_back({Epoch::from_gps_seconds(microseconds / 1'000'000,
                                            1e-6 * static_cast<double>(microseconds % 1'000'000)),
                    table.number(i, "timdotsun"), table.number(i, "timdotmoon")});
  }
  return rows;
}

// Angles from the boresight, degrees: ours, those that another choice would give, and the published ones.
struct Row {
  Epoch epoch;
  double sun, apparent_sun, sun_of_the_earth, otherwise_mounted_sun, moon;
  double published_sun, published_moon;
};

double degrees(const Quantity<si::angle>& angle) {
  return angle.in(si::degree);
}

void print(const std::vector<Row>& rows) {
  std::printf("%-10s  %12s  %12s  %12s\n", "UTC", "off the Sun", "published", "difference");
  std::printf("%-10s  %12s  %12s  %12s\n", "", "deg", "deg", "arcsec");
  constexpr std::size_t ten_minutes = 60;
  for (std::size_t i = 0; i < rows.size(); i += ten_minutes) {
    const Row& row = rows[i];
    std::printf("%-10s  %12.6f  %12.6f  %12.3f\n", row.epoch.utc(0).substr(11).c_str(), row.sun,
                row.published_sun, 3600.0 * (row.sun - row.published_sun));
  }
}

// The difference of two columns over all rows, arcsec.
void compare(const char* text, const std::vector<Row>& rows, double Row::*ours, double Row::*published,
             const char* expected) {
  double sum = 0.0, largest = 0.0;
  for (const Row& row : rows) {
    const double difference = 3600.0 * std::abs(row.*ours - row.*published);
    sum += difference * difference;
    largest = std::max(largest, difference);
  }
  std::printf("%-44s %9.3f %9.3f   %s\n", text, std::sqrt(sum / static_cast<double>(rows.size())), largest,
              expected);
}

void summarise(const std::vector<Row>& rows) {
  std::printf("\n%-44s %9s %9s   expected rms\n%-44s %9s %9s\n", "Less what was published", "rms", "at most",
              "", "arcsec", "arcsec");
  compare("Sun", rows, &Row::sun, &Row::published_sun, "below 0.02: the digits of the telemetry");
  compare("Moon", rows, &Row::moon, &Row::published_moon, "1: eraMoon98 is 7.6 off at most");
  compare("Sun as it is seen, apparent", rows, &Row::apparent_sun, &Row::published_sun, "13: aberration");
  compare("Sun from the centre of the Earth", rows, &Row::sun_of_the_earth, &Row::published_sun,
          "4.5: parallax");
  compare("Sun, the mounting the other way round", rows, &Row::otherwise_mounted_sun, &Row::published_sun,
          "3000: twice the mounting's 0.57 deg");
}

void run(const std::filesystem::path& data) {
  const auto orientation = EarthOrientation::read(data / "finals2000A_april_2023.txt");
  const Sgp4<Satellite> orbit(TwoLineElements::read(data / "CTIM_20230419.tle").front(),
                              at_most(1.0 * si::day));
  const auto attitude = read_attitude(data / "CTIM_20230420_attitude.csv");
  const auto published = read_pointing(data / "CTIM_20230420_pointing.csv");

  // The mounting: v_body = R(q) v_radiometer.
  const auto R_body_from_radiometer =
      dcm(nearest_quaternion_scalar_first(to<Body>, from<Radiometer>, 9.999876e-01, 1.534418e-03,
                                          4.728365e-03, -7.255375e-06)
              .quaternion);
  const SampledAttitude body(attitude, 30.0 * si::second);
  const auto graph = frame_graph(edge(orientation), edge(teme(orientation)), edge(orbit), edge(body),
                                 rigid_edge(R_body_from_radiometer));

  const auto span = from_until(attitude.front().time, attitude.back().time);
  const Ephemeris<sky::Sun> sun(span);
  const Ephemeris<sky::Moon> moon(span);
  const auto boresight = -unit_z(in<Radiometer>);
  // The same nine numbers, claimed to be the inverse.
  const auto R_radiometer_from_body = dcm(to<Radiometer>, from<Body>, R_body_from_radiometer.matrix());

  std::vector<Row> rows;
  for (const Published& row : published) {
    const Epoch& t = row.epoch;
    const auto now = graph.at(t);
    const auto off = [&](const auto& direction) { return degrees(angle_between(boresight, direction)); };
    const auto to_sun = sun.direction(now, seen_from<Satellite>, geometric, in<Radiometer>);
    rows.push_back(
        {t, off(to_sun), off(sun.direction(now, seen_from<Satellite>, apparent, in<Radiometer>)),
         off(sun.direction(now, seen_from<Gcrf>, geometric, in<Radiometer>)),
         off(R_radiometer_from_body * sun.direction(now, seen_from<Satellite>, geometric, in<Body>)),
         off(moon.direction(now, seen_from<Satellite>, geometric, in<Radiometer>)),
         degrees(std::acos(row.cosine_sun) * si::radian), degrees(std::acos(row.cosine_moon) * si::radian)});
  }
  std::printf("CTIM, %s, %zu rows. Data of LASP, University of Colorado.\n\n",
              span.start().utc(0).substr(0, 10).c_str(), rows.size());
  print(rows);
  summarise(rows);
}

}  // namespace

int main(int count, char** words) {
  try {
    run(count > 1 ? words[1] : VECTRIX_EXAMPLE_DATA);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "radiometer_on_sun: %s\n", error.what());
    return 1;
  }
  return 0;
}
