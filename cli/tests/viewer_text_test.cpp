#include "viewer_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "convert.hpp"
#include "message_kind.hpp"
#include "says.hpp"
#include "temporary_folder.hpp"

namespace vectrix::cli::viewer_text_test {
namespace {

PlainAttitude attitude_at(const std::vector<std::string>& times,
                          std::vector<std::array<double, 4>> quaternions, const std::string& reference) {
  PlainAttitude attitude{"SC_BODY_1", reference};
  for (const std::string& time : times) attitude.times.push_back(Epoch::from_utc(time));
  attitude.quaternions = std::move(quaternions);
  return attitude;
}

// Scalar last, of norm 1, the second quaternion with the sign of the first.
TEST(ViewerText, AnAttitudeOfStk) {
  const auto attitude = attitude_at({"2026-11-29T00:00:00.25", "2026-11-29T00:01:00.25"},
                                    {{0.8, 0.6, 0.0, 0.0}, {-1.6, 0.0, -1.2, 0.0}}, "EME2000");
  EXPECT_EQ(stk_attitude(attitude),
            "stk.v.11.0\n\nBEGIN Attitude\n\nNumberOfAttitudePoints 2\n"
            "ScenarioEpoch 29 Nov 2026 00:00:00.250000000\nCentralBody Earth\nCoordinateAxes J2000\n\n"
            "AttitudeTimeQuaternions\n\n0 0.6 0 0 0.8\n60 0 0.6 0 0.8\n\nEND Attitude\n");
  const auto between = attitude_at({"2026-11-29T00:00:00.2499999999", "2026-11-29T00:01:00.25"},
                                   attitude.quaternions, "EME2000");
  EXPECT_EQ(stk_attitude(between), stk_attitude(attitude));  // not from -0 s on
  auto other = attitude;
  other.reference = "GCRF";
  EXPECT_NE(stk_attitude(other).find("CoordinateAxes ICRF"), std::string::npos);
  EXPECT_THROW(stk_attitude(attitude_at({"2016-12-31T23:59:60", "2017-01-01T00:00:00"},
                                        {{1, 0, 0, 0}, {1, 0, 0, 0}}, "GCRF")),
               BadInput);
}

// A body along the axes of GCRF turns in those of the Earth by the angle of its rotation, ERA = 2 pi
// (0.7790572732640 + 1.00273781191135448 days since J2000): v^itrf = R(q) v^gcrf turns x to (cos ERA, -sin
// ERA).
TEST(ViewerText, AnOrientationOfCzmlIsInTheAxesOfTheEarth) {
  const auto attitude =
      attitude_at({"2000-01-01T12:00:00", "2000-01-01T18:00:00"}, {{1, 0, 0, 0}, {1, 0, 0, 0}}, "GCRF");
  const std::string text = czml_attitude(attitude, "A \"B\" \\");
  EXPECT_NE(
      text.find(R"({"id":"A \"B\" \\","availability":"2000-01-01T12:00:00.000000000Z/2000-01-01T18:00:00)"),
      std::string::npos);
  EXPECT_NE(text.find(R"("epoch":"2000-01-01T12:00:00.000000000Z","unitQuaternion":[)"), std::string::npos);
  std::istringstream numbers(text.substr(text.find('[', 5) + 1));
  double days = 0.0;
  for (const double seconds : {0.0, 21600.0}) {
    double t = 0.0, q[4];
    char comma = 0;
    numbers >> t;
    for (double& component : q) numbers >> comma >> component;
    numbers >> comma;
    EXPECT_EQ(t, seconds);
    days = seconds / 86400.0;
    const double era = 2 * std::numbers::pi * (0.7790572732640 + 1.00273781191135448 * days);
    const Eigen::Vector3d x = Eigen::Quaterniond(q[3], q[0], q[1], q[2]) * Eigen::Vector3d::UnitX();
    constexpr double pole = 1e-4;  // of the precession and nutation near J2000, 20 arcsec
    EXPECT_LT((x - Eigen::Vector3d(std::cos(era), -std::sin(era), 0.0)).norm(), pole) << seconds;
  }
}

constexpr const char* orbit_file =
    "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2026-11-29T00:00:00\nORIGINATOR = TEST\nMETA_START\nOBJECT_NAME = "
    "SAT\n"
    "OBJECT_ID = 2026-001A\nCENTER_NAME = EARTH\nREF_FRAME = FRAME\nTIME_SYSTEM = TAI\n"
    "START_TIME = 2026-11-29T00:00:37\nSTOP_TIME = 2026-11-29T00:01:37\nINTERPOLATION = Hermite\n"
    "INTERPOLATION_DEGREE = 3\nMETA_STOP\n2026-11-29T00:00:37 7000 0 0 0 7.5 0\n2026-11-29T00:01:37 6985 450 "
    "0 -.5 7.5 0\n";

std::string orbit_in(const std::string& frame) {
  std::string text = orbit_file;
  return text.replace(text.find("= FRAME") + 2, 5, frame);
}

TEST(ViewerText, AnOrbitOfCzml) {
  TemporaryFolder folder;
  const auto converted = [&](const std::string& frame, const std::string& name) {
    ConvertOptions options{folder.file(name)};
    options.force = true;
    std::ostringstream said;
    convert(OrbitFile{folder.written("in.oem", orbit_in(frame))}, options, said);
    return content(options.out);
  };
  EXPECT_EQ(
      converted("ICRF", "a.czml"),
      "[{\"id\":\"document\",\"version\":\"1.0\"},\n{\"id\":\"SAT\",\"availability\":"
      "\"2026-11-29T00:00:00.000000000Z/2026-11-29T00:01:00.000000000Z\",\n\"position\":{\"referenceFrame\":"
      "\"INERTIAL\",\"interpolationAlgorithm\":\"HERMITE\",\"interpolationDegree\":3,\"epoch\":"
      "\"2026-11-29T00:00:00.000000000Z\",\"cartesianVelocity\":[\n0,7e+06,0,0,0,7500,0,\n"
      "60,6985000,450000,0,-500,7500,0]}}]\n");
  EXPECT_NE(converted("ITRF2014", "b.czml").find("\"FIXED\""), std::string::npos);
  EXPECT_TRUE(says(complaint([&] { converted("EME2000", "c.czml"); }), "CZML has GCRF and ITRF"));
  EXPECT_TRUE(says(complaint([&] { converted("ICRF", "d.a"); }), ".a is of an attitude"));
}

// The first bytes tell an orbit from an attitude, in XML as in keywords.
TEST(ViewerText, AMessageInXmlIsKnownByItsFirstElement) {
  TemporaryFolder folder;
  const std::string oem = "<!-- <aem> -->\n<ndm:oem xmlns:ndm=\"x\" version=\"2.0\"/>";
  const auto is_orbit_message = [](const std::filesystem::path& file) {
    return kind_to_convert(file, "", "out.a").kind == "oem";
  };
  EXPECT_TRUE(is_message(folder.written("a", oem)) && is_orbit_message(folder.written("a", oem)));
  EXPECT_TRUE(is_orbit_message(folder.written("b", "<?xml version=\"1.0\"?><oem/>")));
  EXPECT_FALSE(is_orbit_message(folder.written("c", "<?xml version=\"1.0\"?>\n<aem>\n<oem/></aem>")));
  EXPECT_TRUE(is_orbit_message(folder.written("d", std::string("\xff\xfe<\0o\0e\0m\0>\0", 12))));
  EXPECT_TRUE(is_message(folder.written("d", std::string("\xff\xfe<\0o\0e\0m\0>\0", 12))));
  EXPECT_FALSE(is_message(folder.written("e", "time,q\n1,2\n")));
}

}  // namespace
}  // namespace vectrix::cli::viewer_text_test
