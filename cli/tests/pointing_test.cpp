#include "pointing.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include "attitude_motion.hpp"
#include "cubesat.hpp"
#include "pointing_error.hpp"
#include "quantile.hpp"
#include "resampled.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::pointing_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;
using earth::Gcrf;
using Eigen::Vector3d;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double arcsecond = std::numbers::pi / 648000.0;
const std::filesystem::path data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";
const Convention stated{Scalar::last, Maps::to_reference};

// The flight's own results: the angle between the boresight and the Sun, between the samples of the attitude.
struct Published {
  std::vector<Epoch> times;
  std::vector<double> off_sun;  // rad
};
Published published() {
  const auto table = CsvTable::read(data / "CTIM_20230420_pointing.csv", {});
  Published all;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const auto microseconds = static_cast<std::int64_t>(table.number(i, "microsecondssincegpsepoch"));
    all.times.push_back(Epoch::from_gps_seconds(microseconds / 1'000'000,
                                                1e-6 * static_cast<double>(microseconds % 1'000'000)));
    all.off_sun.push_back(std::acos(table.number(i, "timdotsun")));
  }
  return all;
}

// The mounting turns the boresight by 0.57 deg from -z of the body.
TEST(Pointing, FindsTheAnglesThatACubesatsGroundProcessingHasPublished) {
  const Vector3d boresight =
      Eigen::Quaterniond(9.999876e-01, 1.534418e-03, 4.728365e-03, -7.255375e-06).normalized() *
      Vector3d(0.0, 0.0, -1.0);
  const auto expected = published();
  auto samples = read_attitude(cubesat_attitude());
  samples.longest_step = 30.0;
  const auto record = resampled(samples, expected.times);
  const auto orbit = read_orbit(cubesat_orbit(), from_until(expected.times.front(), expected.times.back()));
  const auto rms = [&](const SkyCorrection& correction, const FlownOrbit& flown, const Vector3d& axis) {
    const auto found =
        absolute_errors(seen_in_body(record, directions(record, Target::sun, correction, flown)), axis);
    double sum = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
      sum += std::pow((found[i] - expected.off_sun[i]) / arcsecond, 2);
    return std::sqrt(sum / static_cast<double>(found.size()));
  };
  ASSERT_EQ(record.size(), 719U);
  constexpr double of_printed_cosines =
      0.03;  // arcsec: cosines near 1, with 16 digits, of a position good to metres
  EXPECT_LE(rms(geometric, orbit, boresight), of_printed_cosines);
  EXPECT_GT(rms(apparent, orbit, boresight), 10.0);
  EXPECT_GT(rms(geometric, nullptr, boresight), 4.0);
  EXPECT_GT(rms(geometric, orbit, {0.0, 0.0, -1.0}), 1000.0);
}

RC_GTEST_PROP(Quantile, IsTheFirstThatSoManyDoNotExceed, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 3000);
  const double percent = 0.1 * *rc::gen::inRange(1, 1001);
  const std::size_t place = place_of_quantile(percent, count);
  constexpr double rounding = 1e-9;
  RC_ASSERT(place < count);
  RC_ASSERT(100.0 * static_cast<double>(place + 1) >= percent * static_cast<double>(count) - rounding);
  RC_ASSERT(place == 0 ||
            100.0 * static_cast<double>(place) < percent * static_cast<double>(count) - rounding);
}

TEST(Quantile, IsNotPushedFurtherByTheRoundingOfThePercents) {
  EXPECT_EQ(place_of_quantile(1.1, 1000), 10U);  // 0.01 * 1.1 * 1000 is above 11
  EXPECT_EQ(place_of_quantile(99.7, 1000), 996U);
  EXPECT_EQ(place_of_quantile(50.0, 2), 0U);
  EXPECT_EQ(place_of_quantile(100.0, 7), 6U);
  EXPECT_EQ(place_of_quantile(0.001, 7), 0U);
}

// A circle in the plane of x and y, and a body at rest in GCRF.
class Circle : public ::testing::Test {
 protected:
  Circle()
      : record(AttitudeMotion{{0.0, 0.0, 1e-12}, {0.0, 0.0, 1e-12}}.record(60, stated, stated, RateAxes::body,
                                                                           RateAxes::body)) {}
  static double angle(double t) { return 1.08e-3 * t; }
  static PointMotion<Gcrf, Satellite, Gcrf> orbit(const Epoch& t) {
    constexpr double r = 7e6, n = 1.08e-3;
    const double u = angle((t - Epoch::from_utc("2026-11-29T00:00:00")).value());
    return point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                        vector<si::length>(in<Gcrf>, r * Vector3d(std::cos(u), std::sin(u), 0.0)),
                        vector<si::velocity>(in<Gcrf>, r * n * Vector3d(-std::sin(u), std::cos(u), 0.0)));
  }
  AttitudeRecord record;
};

TEST_F(Circle, HasItsVelocityAheadAndTheEarthBelow) {
  constexpr double rounding = 1e-9;  // rad: of a body that is turned by 1e-12 rad/s
  const auto ahead = directions(record, Target::velocity, geometric, orbit);
  const auto below = directions(record, Target::earth, geometric, orbit);
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double u = angle(static_cast<double>(i));
    EXPECT_LE(angle_between(ahead[i], {-std::sin(u), std::cos(u), 0.0}), rounding);
    EXPECT_LE(angle_between(below[i], {-std::cos(u), -std::sin(u), 0.0}), rounding);
  }
  record.reference = "EME2000";
  const auto bias = directions(record, Target::velocity, geometric, orbit);
  EXPECT_LE(angle_between(
                bias[0], (eme2000_from_gcrf() * vector<si::dimensionless>(in<Gcrf>, ahead[0])).coordinates()),
            1e-15);
  EXPECT_GT(angle_between(bias[0], ahead[0]), 1e-8);
}

TEST_F(Circle, HasNoDirectionOfNoLength) {
  const auto stopped = [](const Epoch& t) {
    auto motion = orbit(t);
    if (t < Epoch::from_utc("2026-11-29T00:00:05")) return motion;
    return point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                        vector<si::length>(in<Gcrf>, Vector3d::Zero()),
                        vector<si::velocity>(in<Gcrf>, Vector3d::Zero()));
  };
  const auto refusal = [&](Target target) {
    return complaint([&] { (void)directions(record, target, geometric, stopped); });
  };
  EXPECT_EQ(
      refusal(Target::earth),
      "at 2026-11-29T00:00:05.000000 UTC there is no direction of the centre of the Earth, its length is "
      "0");
  EXPECT_EQ(refusal(Target::velocity),
            "at 2026-11-29T00:00:05.000000 UTC there is no direction of the velocity relative to GCRF, its "
            "length is 0");
}

TEST_F(Circle, SeesTheSunInItsYearsOnly) {
  for (Epoch& t : record.times) t = t + 1e5 * 86400.0 * si::second;
  const auto said = complaint([&] { (void)directions(record, Target::sun, geometric, nullptr); });
  EXPECT_EQ(said.substr(0, 19), "the Sun: the epoch ") << said;
  EXPECT_TRUE(says(said, " is outside the years of the series, 1900 to 2099"));
}

TEST_F(Circle, SeesSunAndMoonByTheWordsOfTheLibrary) {
  const auto& t = record.times[7];
  const auto span = from_until(record.times.front(), record.times.back());
  const Ephemeris<sky::Moon> moon(span);
  const auto off = [&](auto seen) {
    return angle_between(directions(record, Target::moon, seen, orbit)[7],
                         moon.direction(t, orbit(t), seen).coordinates());
  };
  constexpr double rounding = 1e-15;
  EXPECT_LE(off(geometric), rounding);
  EXPECT_LE(off(light_time), rounding);
  EXPECT_LE(off(apparent), rounding);
  const auto where = directions(record, Target::sun, geometric, nullptr),
             image = directions(record, Target::sun, apparent, nullptr);
  EXPECT_NEAR(angle_between(where[7], image[7]) / arcsecond, 20.5,
              0.5);  // the Earth's aberration over its year
}

PointingOptions cubesat() {
  PointingOptions options;
  options.attitude = cubesat_attitude();
  options.orbit = cubesat_orbit();
  options.axis = {0.0, 0.0, -1.0};
  options.correction = geometric;
  options.attitude.selection.from = Epoch::from_utc("2023-04-20T05:20:00");
  options.attitude.selection.until = Epoch::from_utc("2023-04-20T06:10:00");
  return options;
}
bool fulfilled(const PointingOptions& options) {
  std::ostringstream out;
  return pointing(options, out);
}

TEST(Pointing, WritesTheAnglesOfTheSamplesThatAreAskedFor) {
  TemporaryFile file("");
  PointingOptions options = cubesat();
  options.csv = file.path();
  EXPECT_EQ(complaint([&] { (void)fulfilled(options); }, file.path()), "FILE: exists; --force overwrites it");
  options.force = true;
  EXPECT_TRUE(fulfilled(options));
  const auto table = CsvTable::read(file.path(), {"time_utc", "angle_deg"});
  AttitudeRecord record = read_attitude(options.attitude);
  EXPECT_LE(*options.attitude.selection.from, record.times.front());
  EXPECT_LE(record.times.back(), *options.attitude.selection.until);
  const auto span = from_until(record.times.front(), record.times.back());
  const auto angles = absolute_errors(
      seen_in_body(record, directions(record, Target::sun, geometric, read_orbit(options.orbit, span))),
      options.axis);
  // At most the largest one.
  options.percent = 100.0;
  options.required = *std::max_element(angles.begin(), angles.end()) * (180.0 / std::numbers::pi);
  EXPECT_TRUE(fulfilled(options));
  options.required = std::nextafter(*options.required, 0.0);
  EXPECT_FALSE(fulfilled(options));
  ASSERT_EQ(table.rows(), record.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    EXPECT_EQ(table.value(i, "time_utc", Epoch::from_utc), record.times[i]);
    EXPECT_EQ(table.number(i, "angle_deg"), angles[i] * (180.0 / std::numbers::pi));
  }
  std::ifstream in(file.path());
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(
      line,
      "# Angle between the axis (0, 0, -1) of the body and the Sun, geometric, seen from the satellite.");
}

TEST(Pointing, DoesNotWriteOverWhatItReads) {
  TemporaryFolder folder;
  PointingOptions options = cubesat();
  const auto copy = folder.file("attitude.csv"), link = folder.file("link.csv");
  std::filesystem::copy_file(options.attitude.file, copy);
  std::filesystem::create_symlink(copy, link);
  options.attitude.file = copy;
  options.csv = link;
  options.force = true;
  EXPECT_EQ(complaint([&] { (void)fulfilled(options); }, link),
            "FILE: is the same file as " + copy.string() + ", which is read");
  const auto tle = folder.file("set.tle");
  std::filesystem::copy_file(options.orbit.elements, tle);
  options.orbit.elements = options.csv = tle;
  EXPECT_EQ(complaint([&] { (void)fulfilled(options); }, tle),
            "FILE: is the same file as " + tle.string() + ", which is read");
  options.orbit = {};
  options.orbit.kernel = options.csv = folder.written("orbit.bsp", "precious");
  EXPECT_EQ(complaint([&] { (void)fulfilled(options); }, options.csv),
            "FILE: is the same file as " + options.csv.string() + ", which is read");
  options.attitude.kernel = KernelWords{.clock = folder.written("clock.tsc", "precious").string()};
  options.csv = options.attitude.kernel->clock;
  EXPECT_EQ(complaint([&] { (void)fulfilled(options); }, options.csv),
            "FILE: is the same file as " + options.csv.string() + ", which is read");
  EXPECT_EQ(content(options.csv), "precious");
  EXPECT_EQ(std::filesystem::file_size(copy),
            std::filesystem::file_size(data / "CTIM_20230420_attitude.csv"));
}

TEST(Pointing, FulfilsWhatIsRequiredOfSoManySamples) {
  PointingOptions options = cubesat();
  options.percent = 95.0;
  options.required = 0.7;
  EXPECT_TRUE(fulfilled(options));
  options.required = 0.5;
  EXPECT_FALSE(fulfilled(options));
  options.required = 0.7;
  options.window = 60.0;
  options.required_relative = 0.1;
  EXPECT_TRUE(fulfilled(options));
  options.required_relative = 0.001;
  EXPECT_FALSE(fulfilled(options));
}

TEST(Pointing, CountsOneWindow) {
  PointingOptions options = cubesat();
  options.window = 2990.0;  // from the first to the last sample
  std::ostringstream out;
  (void)pointing(options, out);
  EXPECT_TRUE(says(out.str(), "\n1 window; 283 more reach over a gap or the end\n"));
  options.window = 2980.0;
  out.str("");
  (void)pointing(options, out);
  EXPECT_TRUE(says(out.str(), "\n2 windows; 282 more reach"));
}

// Of a record that begins before UTC nothing is written, not even what comes before the first time in UTC.
TEST(Pointing, RefusesTimesBeforeUtcAtTheDoor) {
  const auto look = [](const char* first, std::ostream& out) {
    const TemporaryFile table(std::string("t,x,y,z,w\n") + first + ",0,0,0,1\n1960-01-01T00:01:00,0,0,0,1\n");
    PointingOptions options = cubesat();
    options.attitude = {table.path(), TableColumns{}};
    options.attitude.columns->time = "t";
    options.attitude.columns->scale = scale::tai;
    options.attitude.columns->quaternion = {"x", "y", "z", "w"};
    options.attitude.columns->reference = "GCRF";
    options.orbit = {};
    return complaint([&] { (void)pointing(options, out); }, table.path());
  };
  std::ostringstream out;
  EXPECT_EQ(
      look("1960-01-01T00:00:00", out),  // TAI - UTC was 0.943 s
      "FILE: the first sample, 1960-01-01T00:00:32.184 TT, is before 1960, and UTC, in which the figures "
      "are written, is not known then");
  EXPECT_EQ(out.str(), "");
  EXPECT_EQ(look("1960-01-01T00:00:01", out), "nothing was thrown");
  EXPECT_TRUE(says(out.str(), "at 1960-01-01T00:00:00.057 UTC"));
}

TEST(Pointing, RefusesWhatIsNotStated) {
  const auto refusal = [](const auto& change) {
    PointingOptions options = cubesat();
    change(options);
    return complaint([&] { (void)fulfilled(options); }, options.attitude.file);
  };
  EXPECT_EQ(refusal([](auto& o) { o.correction.reset(); }),
            "the Sun is not where it is seen; missing: --correction geometric|light_time|apparent");
  EXPECT_EQ(refusal([](auto& o) { o.target = Target::earth; }),
            "--correction is of the Sun, the Moon and stars, not of the centre of the Earth");
  const StarTarget star{"Vega", {}};
  EXPECT_EQ(refusal([&](auto& o) { o.target = star, o.correction.reset(); }),
            "Vega is not where it is seen; missing: --correction light_time|apparent");
  EXPECT_EQ(refusal([&](auto& o) { o.target = star; }),
            "a catalogue says where a star is seen, not where it is; needed: --correction "
            "light_time|apparent");
  EXPECT_EQ(refusal([&](auto& o) { o.target = star, o.correction = apparent, o.orbit = {}; }),
            "the direction of Vega needs an orbit: --tle, --omm, --oem or --spk");
  const StationTarget station{"Boulder", {GeodeticLatitude(0.0 * si::radian), 0.0 * si::radian, {}}};
  EXPECT_EQ(refusal([&](auto& o) { o.target = station, o.correction.reset(); }),
            "Boulder turns with the Earth; missing: --orientation FILE, finals2000A of the IERS");
  EXPECT_EQ(refusal([](auto& o) { o.orientation = "finals.txt"; }),
            "--orientation is of a station and of ITRF, TIRF and CIRF; the target is the Sun, the attitude "
            "is relative to "
            "GCRF, and "
            "there is no --oem");
  const auto year_before = data / "finals2000A_april_2022.txt";
  EXPECT_TRUE(
      says(refusal([&](auto& o) { o.target = station, o.correction.reset(), o.orientation = year_before; }),
           year_before.string() + ": EarthOrientation: the epoch 2023-04-20T05:20:09"));
  EXPECT_EQ(refusal([](auto& o) { o.target = Target::velocity, o.correction.reset(), o.orbit = {}; }),
            "the direction of the velocity relative to GCRF needs an orbit: --tle, --omm, --oem or --spk");
  EXPECT_EQ(
      refusal([](auto& o) { o.required = 1.0; }),
      "--percent, how many of the samples have to fulfil it, goes with --require or --require-relative");
  EXPECT_EQ(
      refusal([](auto& o) { o.percent = 99.7; }),
      "--percent, how many of the samples have to fulfil it, goes with --require or --require-relative");
  EXPECT_EQ(refusal([](auto& o) { o.required = nan, o.percent = 99.7; }),
            "--require nan is no angle above 0 and at most 180 degrees");
  EXPECT_EQ(refusal([](auto& o) { o.required = 1.0, o.percent = 100.1; }),
            "--percent 100.1 is not above 0 and at most 100");
  EXPECT_EQ(refusal([](auto& o) { o.required_relative = 1.0, o.percent = 99.7; }),
            "--require-relative needs the window of the relative error; missing: --window SECONDS");
  EXPECT_EQ(refusal([](auto& o) { o.window = nan; }), "--window nan is no duration");
  EXPECT_EQ(refusal([](auto& o) { o.force = true; }),
            "--force overwrites the file of --csv, which is not given");
  EXPECT_EQ(refusal([](auto& o) { o.axis.setZero(); }), "--axis (0, 0, 0) has no direction");
  EXPECT_EQ(refusal([](auto& o) { o.attitude.selection.until = Epoch::from_utc("2023-04-20T05:20:10"); }),
            "FILE: the samples from 2023-04-20T05:20:00.000000 UTC until 2023-04-20T05:20:10.000000 UTC are "
            "1; at least two are needed");
  EXPECT_EQ(refusal([](auto& o) { o.attitude.selection.from = Epoch::from_utc("2023-04-20T07:10:00"); }),
            "FILE: the samples from 2023-04-20T07:10:00.000000 UTC until 2023-04-20T06:10:00.000000 UTC are "
            "0; at least two are needed");
}

}  // namespace
}  // namespace vectrix::cli::pointing_test
