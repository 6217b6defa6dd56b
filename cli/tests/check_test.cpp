#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "checked.hpp"
#include "figures.hpp"
#include "says.hpp"
#include "space/tests/temporary_file.hpp"

namespace vectrix::cli::check_test {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;

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
  options.attitude.columns->reference = "MCI";
  EXPECT_EQ(refusal(options),
            "the reference 'MCI' is none of EME2000, J2000, GCRF, ICRF, ITRF, TIRF, CIRF, TEME, TOD, MOD, "
            "LVLH, RTN, "
            "RSW, TNW, NTW and VNC");
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
