#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include <vectrix/space.hpp>

#include "files/replaced.hpp"
#include "temporary_file.hpp"

// What files of the field have that no example shows. The numbers, D exponents and time systems that are
// refused are in the tests of the messages' faults; document types in xml_faults_test.cpp, UTF-16 in
// xml_documents_test.cpp.
namespace vectrix::message_oddities_test {
namespace {

// Mandatory values that are empty, as those of the largest provider are; dates by the day of the year and
// with Z; numbers without a digit before the point and with three digits of exponent; Earth in mixed case; a
// method that does not fit its degree; comments with any letters, within the data.
const std::string attitude_ephemeris =
    "CCSDS_AEM_VERS = 1.0\nCREATION_DATE =\nORIGINATOR =\nMETA_START\nOBJECT_NAME =\nOBJECT_ID "
    "=\nCENTER_NAME = Earth\n"
    "REF_FRAME_A = J2000\nREF_FRAME_B = SC_BODY_1\nATTITUDE_DIR = a2b\nTIME_SYSTEM = utc\n"
    "START_TIME = 2006-090T05:00:00.071Z\nSTOP_TIME = 2006-090T05:00:00.946\nATTITUDE_TYPE = Quaternion\n"
    "QUATERNION_TYPE = last\nINTERPOLATION_METHOD = Linear\nINTERPOLATION_DEGREE = 7\nMETA_STOP\nDATA_START\n"
    "2006-090T05:00:00.071Z .6 -.53E-6 +0 8e-001\nCOMMENT \xC2\xB5 = with what it likes\n"
    "2006-03-31T05:00:00.946 0 0 0 1.000000e+000\nDATA_STOP\n";
const std::string orbit_ephemeris =
    "CCSDS_OEM_VERS = 2.0\nCREATION_DATE =\nORIGINATOR =\nMETA_START\nOBJECT_NAME =\nOBJECT_ID "
    "=\nCENTER_NAME = Earth\n"
    "REF_FRAME = ICRF\nTIME_SYSTEM = UTC\nSTART_TIME = 2006-090T05:00:00Z\nSTOP_TIME = "
    "2006-090T05:01:00\nMETA_STOP\n"
    "COMMENT before the data\n2006-090T05:00:00 -1.600194956730110e+003 .5 7 -.53E-6 7.5e+000 0\n"
    "COMMENT within\n2006-090T05:01:00Z 7000 1 2 3 4 5\n";
const std::string attitude_parameters =
    "CCSDS_APM_VERS = 1.0\nCREATION_DATE =\nORIGINATOR =\nOBJECT_NAME =\nOBJECT_ID =\nCENTER_NAME = Earth\n"
    "TIME_SYSTEM = utc\nCOMMENT \xC2\xB5\nEPOCH = 2006-090T05:00:00.071Z\nQ_FRAME_A = J2000\nQ_FRAME_B = "
    "SC_BODY_1\n"
    "Q_DIR = b2a\nQ1 = .6\nQ2 = -.53E-6\nQ3 = +0\nQC = 8e-001\n";
const std::string orbit_parameters =
    "CCSDS_OPM_VERS = 2.0\nCREATION_DATE =\nORIGINATOR =\nOBJECT_NAME =\nOBJECT_ID =\nCENTER_NAME = Earth\n"
    "REF_FRAME = icrf\nTIME_SYSTEM = utc\nEPOCH = 2006-090T05:00:00.071Z\nX = -1.6e+003 [KM]\nY = .5\nZ = "
    "7.\n"
    "X_DOT = -.53E-6\nY_DOT = 7.5e+000 [km/S]\nZ_DOT = 0\n";

// Comments keep their blanks.
std::string with_line_ends(const std::string& text, const std::string& blanks, const std::string& end) {
  std::string all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    all += line + (line.starts_with("COMMENT") ? "" : blanks) + end;
  return all;
}

// Blanks at the end of lines, the line ends of another system, and the mark of UTF-8 change nothing.
template <class Message> void expect_the_same(const std::string& text) {
  const std::string expected = Message::parse(text).text();
  EXPECT_EQ(Message::parse(expected).text(), expected);
  for (const char* blanks : {"", "  ", " \t "}) {
    for (const char* end : {"\n", "\r\n", "\n\n"}) {
      const TemporaryFile file("\xEF\xBB\xBF" + with_line_ends(text, blanks, end));
      EXPECT_EQ(Message::read(file.path()).text(), expected);
    }
  }
}

TEST(MessageOddities, OfEveryMessage) {
  expect_the_same<AttitudeEphemerisMessage>(attitude_ephemeris);
  expect_the_same<OrbitEphemerisMessage>(orbit_ephemeris);
  expect_the_same<AttitudeParameterMessage>(attitude_parameters);
  expect_the_same<OrbitParameterMessage>(orbit_parameters);
}

TEST(MessageOddities, AreReadAsTheyAreMeant) {
  const Epoch t = Epoch::from_utc("2006-03-31T05:00:00.071");
  const auto attitude = AttitudeEphemerisMessage::parse(attitude_ephemeris).segments().front();
  EXPECT_EQ(attitude.metadata().start_time, t);
  EXPECT_EQ(attitude.metadata().interpolation, "Linear");
  EXPECT_EQ(attitude.metadata().interpolation_degree, 7);
  EXPECT_EQ(attitude.comments(), std::vector<std::string>{"\xC2\xB5 = with what it likes"});
  EXPECT_EQ(attitude.lines(detail::trusted).numbers[1], -.53e-6);
  EXPECT_EQ(AttitudeParameterMessage::parse(attitude_parameters).epoch(), t);
  const auto orbit = OrbitParameterMessage::parse(orbit_parameters);
  EXPECT_EQ(orbit.epoch(), t);
  EXPECT_EQ(orbit.header().originator, "");
  struct Satellite : moving_frame {};
  EXPECT_EQ((orbit.state().samples<earth::Gcrf, Satellite>().front().motion.position.coordinates()),
            Eigen::Vector3d(-1.6e6, 500.0, 7000.0));
}

// A number in base 16 as SPICE writes it, a Fortran exponent, an integer of a telemetry's scale, a unit of
// another system: each is refused where it stands.
TEST(MessageOddities, ThatWouldBeGuessed) {
  for (const char* number : {"'3735472A73DE8A^0'", "6.0D-1", "0x1p-1", "1,5", "1 200", "--1", "1e", "nan"}) {
    EXPECT_NE(
        complaint([&] {
          AttitudeParameterMessage::parse(replaced(attitude_parameters, "= .6", "= " + std::string{number}));
        }).find("line 13, column 6 (Q1): '"),
        std::string::npos)
        << number;
    EXPECT_NE(complaint([&] {
                OrbitParameterMessage::parse(replaced(orbit_parameters, "= .5", "= " + std::string{number}));
              }).find("line 11, column 5 (Y): '"),
              std::string::npos)
        << number;
  }
  EXPECT_NE(complaint([&] {
              AttitudeParameterMessage::parse(replaced(attitude_parameters, "= .6", "= 1200000000"));
            }).find("of a quaternion whose norm is 1.2e+09; it may differ from 1 by 0.01"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              OrbitParameterMessage::parse(replaced(orbit_parameters, "[KM]", "[ft]"));
            }).find("line 10, column 5 (X): '-1.6e+003 [ft]': the unit is [km]"),
            std::string::npos);
}

}  // namespace
}  // namespace vectrix::message_oddities_test
