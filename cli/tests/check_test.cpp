#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "attitude_motion.hpp"
#include "check.hpp"
#include "cubesat.hpp"
#include "figures.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::check_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;

const std::filesystem::path data = std::filesystem::path(VECTRIX_SOURCE_DIR) / "examples/data";

CheckOptions cubesat() {
  CheckOptions options{cubesat_attitude(), cubesat_orbit(), Eigen::Vector3d(0.0, 0.0, -1.0), Target::sun};
  options.attitude.columns->reference = "J2000";
  return options;
}
// 25 s of Sentinel-1A with its gyros, whose axes are not those of the quaternions.
CheckOptions sentinel() {
  CheckOptions options;
  options.attitude.file = data / "S1A_IW_20220414T102211_attitude.csv";
  options.attitude.columns = {
      "time_utc", scale::utc,        {"q0", "q1", "q2", "q3"}, {Scalar::last, Maps::to_reference},
      "GCRF",     {"wx", "wy", "wz"}};
  return options;
}

struct Found {
  bool fits;
  std::string text;
};
Found checked(const CheckOptions& options) {
  std::ostringstream out;
  const bool fits = check(options, out);
  return {fits, out.str()};
}

TEST(Check, ConfirmsTheCubesatAndFindsEachMistakeMadeOnPurpose) {
  const auto right = checked(cubesat());
  EXPECT_TRUE(right.fits);
  EXPECT_TRUE(says(right.text, "The file as stated fits.\n"));
  CheckOptions options = cubesat();
  for (const bool without_orbit : {false, true}) {
    if (without_orbit) options.orbit.elements.clear();
    options.attitude.columns->stated = {Scalar::first, Maps::to_reference};
    EXPECT_TRUE(says(checked(options).text,
                     "Another reading fits, three times better than as stated: transposed.\n"));
    options.attitude.columns->stated = {Scalar::last, Maps::to_body};
    EXPECT_TRUE(says(checked(options).text,
                     "Another reading fits, three times better than as stated: other order of numbers.\n"));
    options.attitude.columns->stated = {Scalar::last, Maps::to_reference};
    const auto both = checked(options);
    EXPECT_FALSE(both.fits);
    EXPECT_TRUE(says(
        both.text, "Another reading fits, three times better than as stated: other order and transposed.\n"));
    EXPECT_TRUE(says(both.text, "The file as stated does not fit.\n"));
  }
}

TEST(Check, DecidesNothingForAnAxisThatLooksElsewhere) {
  CheckOptions options = cubesat();
  options.axis = Eigen::Vector3d(1.0, 0.0, 0.0);
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "Not decided. Rates (--rates) may decide"));
}

TEST(Check, TakesAnAxisAtMostFiveDegreesFromItsTarget) {
  CheckOptions options = cubesat();
  options.orbit = {};
  const auto leaning = [&](double angle) {
    options.axis = Eigen::Vector3d(std::sin(angle / degrees), 0.0, -std::cos(angle / degrees));
    return checked(options);
  };
  EXPECT_TRUE(leaning(4.3).fits);  // the median is half a degree more
  const auto found = leaning(4.7);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "  No reading fits.\n"));
}

// It turns by 0.38 deg/s.
TEST(Check, TakesNoBodyForSteadyThatIsNot) {
  CheckOptions options = cubesat();
  options.axis.reset();
  options.target.reset();
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "  No reading fits.\n"));
}

// The rates fit as stated only if they are in other axes than stated, and the axis looks at the Sun as
// stated.
TEST(Check, SaysWhichReadingFitsAllComparisons) {
  const Eigen::Vector3d w(1e-3, -2e-3, 1.5e-3);
  const Eigen::Quaterniond start = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized();
  std::ostringstream rows;
  rows.precision(17);
  rows << "t,w,x,y,z,wx,wy,wz\n";
  AttitudeRecord record;
  record.reference = "GCRF";
  for (int i = 0; i < 3; ++i) {
    record.times.push_back(Epoch::from_utc("2026-03-01T00:00:00") + 4.0 * i * si::second);
    const Eigen::Quaterniond q = start * AttitudeMotion::turned((4.0 * i + 1e-9) * w);
    rows << record.times.back().utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
         << w.x() << ',' << w.y() << ',' << w.z() << '\n';
  }
  const TemporaryFile file(rows.str());
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {
      "t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference}, "GCRF", {"wx", "wy", "wz"}};
  options.attitude.columns->rate_axes = RateAxes::reference;
  options.axis = start.conjugate() * directions(record, Target::sun, geometric, nullptr)[0];
  options.target = Target::sun;
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(
      found.text,
      "\nThe file as stated does not fit. One reading fits all comparisons: as stated, rates in the axes "
      "of the body.\n"));
}

// The rates are those of the file as stated; the axis looks at the Sun if the file is transposed.
TEST(Check, SaysThatTheComparisonsContradictEachOther) {
  const Eigen::Vector3d w(1e-3, -2e-3, 1.5e-3);
  AttitudeRecord record;
  record.reference = "GCRF";
  std::ostringstream rows;
  rows.precision(17);
  rows << "t,w,x,y,z,wx,wy,wz\n";
  const Eigen::Quaterniond start = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized();
  for (int i = 0; i < 3; ++i) {
    record.times.push_back(Epoch::from_utc("2026-03-01T00:00:00") + 4.0 * i * si::second);
    const Eigen::Quaterniond q = start * AttitudeMotion::turned((4.0 * i + 1e-9) * w);
    rows << record.times.back().utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ','
         << w.x() << ',' << w.y() << ',' << w.z() << '\n';
  }
  TemporaryFile file(rows.str());
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {
      "t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference}, "GCRF", {"wx", "wy", "wz"}};
  options.axis = start * directions(record, Target::sun, geometric, nullptr)[0];
  options.target = Target::sun;
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "three times better than as stated: transposed.\n"));
  EXPECT_TRUE(
      says(found.text,
           "\nThe comparisons contradict each other: one confirms the file as stated, one does not.\n"));
}

TEST(Check, FindsTheAxesOfSentinelsGyros) {
  const auto found = checked(sentinel());
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "as stated, with x, y, z of the rates along -y, -x, -z of the body"));
  CheckOptions transposed = sentinel();
  transposed.attitude.columns->stated.maps = Maps::to_body;
  EXPECT_TRUE(
      says(checked(transposed).text, "transposed, with x, y, z of the rates along -y, -x, -z of the body"));
}

// A body with a motion of its own, as a table whose rates are changed.
template <class Change>
Found of_motion(const AttitudeMotion& motion, const Change& change, std::size_t count = 60) {
  const Convention stated{Scalar::last, Maps::to_reference};
  AttitudeRecord record = motion.record(count, stated, stated, RateAxes::body, RateAxes::body);
  std::ostringstream rows;
  rows.precision(17);
  rows << "t,x,y,z,w,wx,wy,wz\n";
  for (std::size_t i = 0; i < count; ++i) {
    const auto& q = record.numbers[i];
    const Eigen::Vector3d w = change(Eigen::Vector3d(record.rates[i]));
    rows << record.times[i].utc(9) << ',' << q[0] << ',' << q[1] << ',' << q[2] << ',' << q[3] << ',' << w.x()
         << ',' << w.y() << ',' << w.z() << '\n';
  }
  TemporaryFile file(rows.str());
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {"t", scale::utc, {"x", "y", "z", "w"}, stated, "GCRF", {"wx", "wy", "wz"}};
  return checked(options);
}
const AttitudeMotion tumble{{0.02, 0.01, -0.03}, {0.05, -0.02, 0.01}};
const AttitudeMotion spinner{{1e-4, 2e-4, 0.0}, {0.0102, -0.0204, 0.102}};  // about an axis near z

TEST(Check, ConfirmsRatesAndSaysWhatRatesDoNotSee) {
  const auto found = of_motion(tumble, [](const Eigen::Vector3d& w) { return w; });
  EXPECT_TRUE(found.fits) << found.text;
  EXPECT_TRUE(
      says(found.text, "Rates alone do not see a transposed file whose rates are those of the reference"));
}

// About one axis that is none of the body's: its rates are the same in both frames, from identity on.
TEST(Check, DoesNotRefuteASlewAboutOneAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  const auto found = of_motion(
      {0.004 * axis, 0.006 * axis}, [](const Eigen::Vector3d& w) { return w; }, 5);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(
      says(found.text,
           "The file as stated fits, but this does not tell it from: as stated, rates in the axes of GCRF."));
  EXPECT_TRUE(says(found.text, "Not decided."));
}

// What is left of a wrong sign of a small rate is a fifth of the rates: three times less than any other
// reading.
TEST(Check, FindsTheWrongSignOfASmallRate) {
  const auto found =
      of_motion(spinner, [](const Eigen::Vector3d& w) { return Eigen::Vector3d(w.x(), -w.y(), w.z()); });
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text,
                   "Another reading fits: as stated, with x, y, z of the rates along x, -y, z of the body"));
}

TEST(Check, SuspectsDegreesForRadians) {
  const auto found =
      of_motion(tumble, [&](const Eigen::Vector3d& w) { return Eigen::Vector3d(degrees * w); });
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "times the rates: degrees for radians?"));
  const auto zero = of_motion(tumble, [](const Eigen::Vector3d& w) { return Eigen::Vector3d(0.0 * w); });
  EXPECT_TRUE(says(zero.text, "No reading fits. The rates are zero, and the body turns."));
}

// In degrees, and the axis looks at the Sun: what is right of the file does not excuse its rates.
TEST(Check, ConfirmsNoFileWhoseRatesContradictIt) {
  const Eigen::Vector3d w(1e-3, -2e-3, 1.5e-3);
  const Eigen::Quaterniond start = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.4).normalized();
  const auto of_rates = [&](double factor) {
    std::ostringstream rows;
    rows.precision(17);
    rows << "t,w,x,y,z,wx,wy,wz\n";
    AttitudeRecord record;
    record.reference = "GCRF";
    for (int i = 0; i < 3; ++i) {
      record.times.push_back(Epoch::from_utc("2026-03-01T00:00:00") + 4.0 * i * si::second);
      const Eigen::Quaterniond q = start * AttitudeMotion::turned((4.0 * i + 1e-9) * w);
      const Eigen::Vector3d written = factor * w;
      rows << record.times.back().utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z()
           << ',' << written.x() << ',' << written.y() << ',' << written.z() << '\n';
    }
    const TemporaryFile file(rows.str());
    CheckOptions options;
    options.attitude.file = file.path();
    options.attitude.columns = {
        "t",    scale::utc,        {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference},
        "GCRF", {"wx", "wy", "wz"}};
    options.axis = start.conjugate() * directions(record, Target::sun, geometric, nullptr)[0];
    options.target = Target::sun;
    return checked(options);
  };
  EXPECT_TRUE(of_rates(1.0).fits);
  const auto found = of_rates(degrees);
  EXPECT_FALSE(found.fits) << found.text;
  EXPECT_TRUE(says(found.text, "degrees for radians?"));
  EXPECT_TRUE(says(found.text, "\nThe file as stated does not fit: the rates contradict it.\n"));
  EXPECT_FALSE(of_rates(1.15).fits);  // what is left is above a tenth
  EXPECT_TRUE(of_rates(1.05).fits);
}

// Relative to LVLH, which turns by 0.06 deg/s, and the rates are relative to GCRF.
TEST(Check, FindsRatesRelativeToGcrfOfAnAttitudeThatIsNot) {
  struct Lvlh : moving_frame {};
  const AttitudeMotion motion{{1e-3, 0.0, 5e-4}, {0.0, -7e-4, 1e-3}};  // relative to GCRF
  const auto start = Epoch::from_utc("2023-04-20T05:20:00");
  const FlownOrbit orbit = read_orbit(cubesat_orbit(), from_until(start, start + 60.0 * si::second));
  std::ostringstream rows;
  rows.precision(17);
  rows << "t,w,x,y,z,wx,wy,wz\n";
  for (int i = 0; i < 60; ++i) {
    const Epoch t = start + i * si::second;
    const auto [r, v] = orbit(t);
    const Eigen::Quaterniond lvlh_from_gcrf(Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix().transpose()));
    const Eigen::Quaterniond q = lvlh_from_gcrf * motion.to_reference(i + 1e-9);
    const Eigen::Vector3d w = motion.rate_in_body(i + 1e-9);
    rows << t.utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << ',' << w.x() << ','
         << w.y() << ',' << w.z() << '\n';
  }
  const TemporaryFile file(rows.str());
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {
      "t", scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference}, "LVLH", {"wx", "wy", "wz"}};
  options.orbit = cubesat_orbit();
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(
      says(found.text,
           "Another reading fits, three times better than as stated: as stated, rates relative to GCRF "
           "in the axes of the body.\n"));
  EXPECT_TRUE(says(found.text, "The file as stated does not fit."));
}

// It looks at the Earth, with times in UTC; a low orbit turns by 2 deg in the 37 s from UTC to TAI.
TEST(Check, FindsTheScaleOfTheTimes) {
  struct Lvlh : moving_frame {};
  const auto start = Epoch::from_utc("2023-04-20T05:20:00");
  const FlownOrbit orbit = read_orbit(cubesat_orbit(), from_until(start, start + 600.0 * si::second));
  const auto stated_in = [&](const TimeScale& stated, double leaning) {
    std::ostringstream rows;
    rows.precision(17);
    rows << "t,w,x,y,z\n";
    for (int i = 0; i < 60; ++i) {
      const Epoch t = start + 10.0 * i * si::second;
      const auto [r, v] = orbit(t);
      const Eigen::Quaterniond q(Eigen::Matrix3d(lvlh(from<Lvlh>, r, v).matrix() *
                                                 Eigen::AngleAxisd(leaning, Eigen::Vector3d::UnitX())));
      rows << t.utc(9) << ',' << q.w() << ',' << q.x() << ',' << q.y() << ',' << q.z() << '\n';
    }
    const TemporaryFile file(rows.str());
    CheckOptions options;
    options.attitude.file = file.path();
    options.attitude.columns = {"t",    stated, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference},
                                "GCRF", {}};
    options.orbit = cubesat_orbit();
    options.axis = Eigen::Vector3d::UnitZ();
    options.target = Target::earth;
    return checked(options);
  };
  constexpr double small_lean = 0.1 / degrees, large_lean = 3.0 / degrees;
  const auto right = stated_in(scale::utc, small_lean);
  EXPECT_TRUE(right.fits) << right.text;
  EXPECT_EQ(right.text.find("times in"), std::string::npos);
  EXPECT_TRUE(stated_in(scale::utc, large_lean).fits);  // across the orbit, which no time explains
  const auto wrong = stated_in(scale::tai, small_lean);
  EXPECT_FALSE(wrong.fits) << wrong.text;
  EXPECT_TRUE(
      says(wrong.text, "Another reading fits: as stated, times in UTC, which the file states in TAI.\n"));
  EXPECT_TRUE(says(wrong.text, "\nThe file as stated does not fit: with its times in UTC it does.\n"));
}

TEST(Check, AsksOnlyForWhatIsNotGiven) {
  CheckOptions options = cubesat();
  options.axis = Eigen::Vector3d(1.0, 0.0, 0.0);
  EXPECT_TRUE(says(checked(options).text, "\nNot decided. Rates (--rates) may decide.\n"));
  options.orbit = {};
  EXPECT_TRUE(says(checked(options).text,
                   "\nNot decided. Rates (--rates) or an orbit (--tle, --omm, --oem, --spk) may decide.\n"));
}

TEST(Check, RefusesRatesWhoseSizeOverflows) {
  const auto huge = [](const Eigen::Vector3d& w) { return Eigen::Vector3d(1e200 * w); };
  EXPECT_TRUE(
      says(complaint([&] { (void)of_motion(tumble, huge); }), ": the rates are too large, inf rad/s rms"));
}

TEST(Check, DecidesNothingForABodyAtRestWithoutRates) {
  const auto found =
      of_motion({{1e-300, 0.0, 0.0}, {0.0, 1e-300, 0.0}}, [](const Eigen::Vector3d& w) { return w; });
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "Not decided."));
}

// Attitudes that look at nothing: 10.1, 13.1, 52.2 and 141.1 deg from the Sun.
TEST(Check, TakesNoAxisThatIsFarFromItsTarget) {
  TemporaryFile file(
      "t,w,x,y,z\n2026-03-01T00:00:00,-0.75,0.29,-0.59,-0.07\n2026-03-01T00:00:10,-0.75,0.29,-0.59,-0.07\n"
      "2026-03-01T00:00:20,-0.75,0.29,-0.59,-0.07\n");
  CheckOptions options;
  options.attitude.file = file.path();
  options.attitude.columns = {"t",    scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_reference},
                              "GCRF", {}};
  options.axis = Eigen::Vector3d(0.0, 0.0, 1.0);
  options.target = Target::sun;
  const auto found = checked(options);
  EXPECT_FALSE(found.fits);
  EXPECT_TRUE(says(found.text, "  No reading fits.\n"));
}

constexpr const char* head =
    "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2026-11-29T00:00:00\nORIGINATOR = TEST\nMETA_START\nOBJECT_NAME = "
    "S\n"
    "OBJECT_ID = 2026-001A\nREF_FRAME_A = SC_BODY_1\nREF_FRAME_B = EME2000\n";

// One attitude, 36.87 deg about x in 3 minutes, as messages with their own conventions.
TEST(Check, TakesTheConventionOfAMessageFromIt) {
  const auto message = [](const char* direction, const char* type, const char* line, const char* next) {
    return std::string(head) + "ATTITUDE_DIR = " + direction +
           "\nTIME_SYSTEM = UTC\nSTART_TIME = 2026-11-29T00:00:00\nSTOP_TIME = 2026-11-29T00:03:00\n"
           "ATTITUDE_TYPE = QUATERNION/RATE\nQUATERNION_TYPE = " +
           type + "\nRATE_FRAME = REF_FRAME_A\nMETA_STOP\nDATA_START\n2026-11-29T00:00:00 " + line +
           " 0.4096660 0 0\n2026-11-29T00:03:00 " + next + " 0.4096660 0 0\nDATA_STOP\n";
  };
  const auto text = [](const std::string& written) {
    TemporaryFile file(written);
    CheckOptions options;
    options.attitude.file = file.path();
    return checked(options).text;
  };
  const auto a2b = text(message("A2B", "FIRST", "1 0 0 0", "0.8 0.6 0 0"));
  EXPECT_TRUE(says(a2b, "2 samples of SC_BODY_1 relative to EME2000"));
  EXPECT_TRUE(says(a2b, "As stated, R(q) takes coordinates to SC_BODY_1; the scalar is first."));
  // The rate of B relative to A, as AttitudeEphemerisSegment has it: that of the body is its negative.
  EXPECT_TRUE(says(a2b,
                   "The file as stated fits, but this does not tell it from: as stated, rates in the axes "
                   "of EME2000."));  // x is one axis in both frames
  EXPECT_EQ(a2b.find("Another reading"), std::string::npos) << a2b;
  const auto b2a = text(message("B2A", "LAST", "0 0 0 1", "0.6 0 0 0.8"));
  EXPECT_TRUE(says(b2a, "As stated, R(q) takes coordinates to EME2000; the scalar is last."));
  EXPECT_TRUE(
      says(b2a,
           "The rates are not used: with ATTITUDE_DIR B2A the message does not say whether they are of "
           "SC_BODY_1 or of EME2000."));
}

// The orbit, and the place from which the Sun is seen, are of the Earth.
TEST(Check, RefusesAnAttitudeAboutAnotherCentre) {
  const auto about = [](const std::string& centre) {
    const TemporaryFile file(
        std::string(head) + (centre.empty() ? "" : "CENTER_NAME = " + centre + "\n") +
        "ATTITUDE_DIR = B2A\nTIME_SYSTEM = UTC\nSTART_TIME = 2026-11-29T00:00:00\n"
        "STOP_TIME = 2026-11-29T00:03:00\nATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\nMETA_STOP\n"
        "DATA_START\n2026-11-29T00:00:00 0 0 0 1\n2026-11-29T00:03:00 0.6 0 0 0.8\nDATA_STOP\n");
    CheckOptions options;
    options.attitude.file = file.path();
    const auto alone = checked(options);  // where the centre does not matter
    EXPECT_FALSE(alone.fits);
    options.axis = Eigen::Vector3d::UnitZ();
    options.target = Target::sun;
    return complaint([&] { (void)checked(options); }, options.attitude.file);
  };
  EXPECT_EQ(about("MARS"), "FILE: CENTER_NAME is 'MARS'; the attitude must be about EARTH");
  EXPECT_EQ(about("Earth"), "nothing was thrown");
  EXPECT_EQ(about(""), "nothing was thrown");
}

std::string refusal(const CheckOptions& options) {
  return complaint([&] { (void)checked(options); }, options.attitude.file);
}

TEST(Check, RefusesWhatItCannotCompare) {
  CheckOptions options = cubesat();
  options.axis = Eigen::Vector3d::Zero();
  EXPECT_EQ(refusal(options), "--axis (0, 0, 0) has no direction");
  options.axis = Eigen::Vector3d(0.0, 1e200, 0.0);
  EXPECT_EQ(refusal(options), "--axis (0, 1e+200, 0) has no direction");
  options.axis = Eigen::Vector3d(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_EQ(refusal(options), "--axis (1, nan, 0) has no direction");
  options = cubesat();
  options.axis.reset();
  EXPECT_EQ(refusal(options),
            "--axis and --target go together: an axis of the body, and what it should look at");
  options = cubesat();
  options.orbit.elements.clear();
  options.target = Target::moon;
  EXPECT_EQ(refusal(options), "the direction of the Moon needs an orbit: --tle, --omm, --oem or --spk");
  options = cubesat();
  options.attitude.columns->reference = "TOD";
  EXPECT_EQ(refusal(options),
            "the reference 'TOD' is none of EME2000, J2000, GCRF, ICRF, ITRF, TEME, LVLH, RTN, RSW, TNW, NTW "
            "and VNC");
  options = cubesat();
  options.orbit.message = "some.oem";
  EXPECT_EQ(refusal(options),
            "two orbits are given, --tle " + options.orbit.elements.string() + " and --oem some.oem");
  options = cubesat();
  options.attitude.columns->time = "TIME";
  EXPECT_EQ(refusal(options).substr(0, 10), "table FILE");
}

TEST(Check, RefusesTablesThatAreNoAttitude) {
  const auto of = [](const std::string& rows) {
    TemporaryFile file("t,w,x,y,z\n" + rows);
    CheckOptions options;
    options.attitude.file = file.path();
    options.attitude.columns = {"t",    scale::utc, {"w", "x", "y", "z"}, {Scalar::first, Maps::to_body},
                                "GCRF", {}};
    return refusal(options);
  };
  EXPECT_EQ(of("2026-11-29T00:00:00,1,0,0,0\n"), "FILE: there is 1 sample; at least two are needed");
  EXPECT_EQ(of("2026-11-29T00:00:00,1,0,0,0\n2026-11-29T00:00:00,1,0,0,0\n"),
            "table FILE, line 3, column 1 ('t'): 2026-11-29T00:00:00 is not after the row before");
  EXPECT_EQ(
      of("2026-11-29T00:00:00,1,0,0,0\n2026-11-29T00:00:01,0,0,0,0\n"),
      "table FILE, line 3, column 2 ('w'): the squared norm of the quaternion is 0; it has no direction");
  EXPECT_EQ(
      of("2026-11-29T00:00:00,1e200,0,0,0\n2026-11-29T00:00:01,1,0,0,0\n"),
      "table FILE, line 2, column 2 ('w'): the squared norm of the quaternion is inf; it has no direction");
  EXPECT_EQ(of("2026-11-29T00:00:00,1,nan,0,0\n"),
            "table FILE, line 2, column 3 ('x'): 'nan' is not a finite number");
}

}  // namespace
}  // namespace vectrix::cli::check_test
