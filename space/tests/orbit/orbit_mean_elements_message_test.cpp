#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>

#include <vectrix/space/orbit/sgp4.hpp>

#include "orbit/check_sum.hpp"
#include "temporary_file.hpp"

namespace vectrix::orbit_mean_elements_message_test {
namespace {

using Message = OrbitMeanElementsMessage;
struct Ship : moving_frame {};

constexpr double conversion = 2 * std::numeric_limits<double>::epsilon();  // a unit rounds number and factor

// The ISS as CelesTrak has it: figures of open-space-collective/ccsds-data-messages (at d934e096,
// Apache-2.0).
const std::string iss = R"(CCSDS_OMM_VERS = 2.0
COMMENT A comment = with what it likes: µ
CREATION_DATE  =
ORIGINATOR     =

OBJECT_NAME    = ISS (ZARYA)
OBJECT_ID      = 1998-067A
CENTER_NAME    = EARTH
REF_FRAME      = TEME
TIME_SYSTEM    = UTC
MEAN_ELEMENT_THEORY = SGP/SGP4
EPOCH          = 2026-07-21T04:27:10.178208
MEAN_MOTION    = 15.49071756
ECCENTRICITY   = .00068493
INCLINATION    = 51.6316
RA_OF_ASC_NODE = 131.8443
ARG_OF_PERICENTER = 320.6461
MEAN_ANOMALY   = 39.4029
EPHEMERIS_TYPE = 0
CLASSIFICATION_TYPE = U
NORAD_CAT_ID   = 25544
ELEMENT_SET_NO = 999
REV_AT_EPOCH   = 57702
BSTAR          = .11479289E-3
MEAN_MOTION_DOT = .5896E-4
MEAN_MOTION_DDOT = 0
)";

// The text with another line for the one of the keyword.
std::string with(const std::string& keyword, const std::string& line) {
  std::string text = iss;
  const auto begin = text.find("\n" + keyword) + 1;
  return text.replace(begin, text.find('\n', begin) - begin, line);
}
std::string complaint_of(const std::string& text) {
  return complaint([&] { Message::parse(text); });
}

TEST(OrbitMeanElementsMessage, ValuesOfTheIss) {
  const auto message = Message::parse(iss);
  EXPECT_EQ(message.object_name(), "ISS (ZARYA)");
  EXPECT_EQ(message.object_id(), "1998-067A");
  EXPECT_EQ(message.catalogue_number(), 25544);
  EXPECT_EQ(message.epoch().utc(), "2026-07-21T04:27:10.178208");
  EXPECT_EQ(*message.text("MEAN_MOTION_DOT"), ".5896E-4");
  EXPECT_EQ(*message.text("CREATION_DATE"), "");
  EXPECT_EQ(*message.text("CCSDS_OMM_VERS"), "2.0");
  EXPECT_EQ(message.text("MASS"), nullptr);
  const MeanElements& x = message.mean_elements();
  const auto near = [](double value, double expected) {
    EXPECT_NEAR(value, expected, conversion * expected);
  };
  const double degree = std::numbers::pi / 180.0;
  EXPECT_EQ(x.epoch, message.epoch());
  EXPECT_EQ(x.eccentricity, 0.00068493);
  near(x.mean_motion.value(), 15.49071756 * 2 * std::numbers::pi / 86400.0);
  near(x.inclination.value(), 51.6316 * degree);
  near(x.ascending_node.value(), 131.8443 * degree);
  near(x.argument_of_perigee.value(), 320.6461 * degree);
  near(x.mean_anomaly.angle.value(), 39.4029 * degree);
  near(x.bstar.value() * 6378135.0, 0.11479289e-3);
}

// The same figures in both forms are the same motion: those of the verification of SGP4, deep space included.
TEST(OrbitMeanElementsMessage, IsTheMotionOfTheTwoLines) {
  // The epoch is written to 1e-9 s; the numbers are the same.
  constexpr double written = 1e-9;
  const auto file = std::filesystem::path{VECTRIX_SOURCE_DIR} / "space/tests/data/sgp4_sets.tle";
  const auto sets = TwoLineElements::read(file);
  ASSERT_EQ(sets.size(), 11U);
  for (const auto& set : sets) {
    const MeanElements& x = set.mean_elements();
    const auto number = [](double value) {
      char text[40];
      std::snprintf(text, sizeof text, "%.17g", value);
      return std::string{text};
    };
    const double degree = std::numbers::pi / 180.0;
    const std::string text =
        "CCSDS_OMM_VERS = 3.0\nOBJECT_NAME = X\nOBJECT_ID = Y\nCENTER_NAME = Earth\nREF_FRAME = TEME\n"
        "TIME_SYSTEM = UTC\nMEAN_ELEMENT_THEORY = SGP4\nEPOCH = " +
        x.epoch.utc(9) +
        "\nMEAN_MOTION = " + number(x.mean_motion.value() * 86400.0 / (2 * std::numbers::pi)) +
        " [rev/day]\nECCENTRICITY = " + number(x.eccentricity) +
        "\nINCLINATION = " + number(x.inclination.value() / degree) +
        " [deg]\nRA_OF_ASC_NODE = " + number(x.ascending_node.value() / degree) +
        " [deg]\nARG_OF_PERICENTER = " + number(x.argument_of_perigee.value() / degree) +
        " [deg]\nMEAN_ANOMALY = " + number(x.mean_anomaly.angle.value() / degree) +
        " [deg]\nGM = 398600.8 [km**3/s**2]\nBSTAR = " + number(x.bstar.value() * 6378135.0) + " [1/ER]\n";
    const Sgp4<Ship> by_lines(set, at_most(72.0 * si::hour)),
        by_message(Message::parse(text), at_most(72.0 * si::hour));
    for (const double hours : {-48.0, 0.0, 30.0}) {
      const Epoch t = x.epoch + convert<si::time>(hours * si::hour);
      const auto a = by_lines.at(t), b = by_message.at(t);
      const double v = a.velocity.coordinates().norm();
      // An ulp of each number, in revolutions, of which there are up to 50.
      const double rounding = 1e-14 * 50 * a.position.coordinates().norm();
      EXPECT_LE((a.position.coordinates() - b.position.coordinates()).norm(), v * written + 10 * rounding)
          << set.catalogue_number() << ' ' << hours;
    }
  }
}

// The two lines of the same set have an eccentricity of seven decimals, and five digits of B*.
TEST(OrbitMeanElementsMessage, HasMoreDigitsThanTwoLines) {
  const auto set =
      TwoLineElements::parse(summed("1 25544U 98067A   26202.18553447  .00005896  00000-0  11479-3 0  999"),
                             summed("2 25544  51.6316 131.8443 0006849 320.6461  39.4029 15.4907175657702"));
  EXPECT_EQ(set.epoch().utc(), "2026-07-21T04:27:10.178208");
  const Sgp4<Ship> by_lines(set, at_most(72.0 * si::hour)),
      by_message(Message::parse(iss), at_most(72.0 * si::hour));
  // 2 a of half a unit in the last place of the eccentricity, and as much again for B* in half a day.
  constexpr double digits = 2 * 6.8e6 * 0.5e-7;
  double off = 0.0;
  for (double hours = -12.0; hours <= 12.0; hours += 0.5) {
    const Epoch t = set.epoch() + convert<si::time>(hours * si::hour);
    off = std::max(off,
                   (by_lines.at(t).position.coordinates() - by_message.at(t).position.coordinates()).norm());
  }
  EXPECT_LE(off, 2 * digits);
  EXPECT_GE(off, 0.1 * digits);
}

TEST(OrbitMeanElementsMessage, OtherTheoriesFramesAndScalesAreRefused) {
  EXPECT_EQ(complaint_of(with("MEAN_ELEMENT_THEORY", "MEAN_ELEMENT_THEORY = SGP4-XP")),
            "orbit mean-elements message, line 11, column 23 (MEAN_ELEMENT_THEORY): 'SGP4-XP': it must be "
            "SGP4 for the elements of SGP4");
  EXPECT_EQ(complaint_of(with("REF_FRAME", "REF_FRAME = EME2000")),
            "orbit mean-elements message, line 9, column 13 (REF_FRAME): 'EME2000': it must be TEME for the "
            "elements of SGP4");
  EXPECT_EQ(complaint_of(with("TIME_SYSTEM", "TIME_SYSTEM = TAI")),
            "orbit mean-elements message, line 10, column 15 (TIME_SYSTEM): 'TAI': it must be UTC for the "
            "elements of SGP4");
  EXPECT_EQ(complaint_of(with("CENTER_NAME", "CENTER_NAME = MOON")),
            "orbit mean-elements message, line 8, column 15 (CENTER_NAME): 'MOON': it must be EARTH for the "
            "elements of SGP4");
  for (const char* type : {"1", "4", "3.0", "", "x"})
    EXPECT_NE(
        complaint_of(with("EPHEMERIS_TYPE", "EPHEMERIS_TYPE = " + std::string{type})).find("another theory"),
        std::string::npos)
        << type;
  EXPECT_NO_THROW(Message::parse(with("EPHEMERIS_TYPE", "EPHEMERIS_TYPE = 3")));
  const std::string version3 = "CCSDS_OMM_VERS = 3.0" + iss.substr(iss.find('\n'));
  EXPECT_NO_THROW(Message::parse(version3));
  EXPECT_NE(complaint_of("CCSDS_OMM_VERS = 3.0" +
                         with("EPHEMERIS_TYPE", "EPHEMERIS_TYPE = 3").substr(iss.find('\n')))
                .find("another theory"),
            std::string::npos);
  EXPECT_EQ(
      complaint_of("CCSDS_OMM_VERS = 1.0\n"),
      "orbit mean-elements message, line 1, column 18 (CCSDS_OMM_VERS): '1.0': the versions are 2.0, 3.0");
  EXPECT_NE(complaint_of(with("MEAN_MOTION ", "SEMI_MAJOR_AXIS = 6800")).find("MEAN_MOTION instead"),
            std::string::npos);
  EXPECT_NE(complaint_of(iss + "GM = 398600.4418\n").find("of WGS-72"), std::string::npos);
  EXPECT_NO_THROW(Message::parse(iss + "GM = 398600.8\n"));
}

TEST(OrbitMeanElementsMessage, WrongNumbersAreRefused) {
  EXPECT_EQ(complaint_of(with("INCLINATION", "INCLINATION = 181")),
            "orbit mean-elements message, line 15, column 15 (INCLINATION): '181': not in [0, 180] deg");
  EXPECT_EQ(complaint_of(with("INCLINATION", "INCLINATION = 51.6 [rad]")),
            "orbit mean-elements message, line 15, column 15 (INCLINATION): '51.6 [rad]': the unit is [deg]");
  EXPECT_EQ(complaint_of(with("ECCENTRICITY", "ECCENTRICITY = .1 [deg]")),
            "orbit mean-elements message, line 14, column 16 (ECCENTRICITY): '.1 [deg]': it has no unit");
  EXPECT_EQ(complaint_of(with("MEAN_MOTION ", "MEAN_MOTION = 0.00113")), "nothing was thrown");
  EXPECT_EQ(complaint_of(with("MEAN_MOTION ", "  MEAN_MOTION =  929.4")),
            "orbit mean-elements message, line 13, column 18 (MEAN_MOTION): '929.4': not in (0, 17] rev/day");
  EXPECT_EQ(complaint_of(with("BSTAR", "BSTAR = -1e9")),
            "orbit mean-elements message, line 24, column 9 (BSTAR): '-1e9': not in [-100, 100] 1/ER");
  EXPECT_EQ(complaint_of(with("BSTAR", "BSTAR = -100")), "nothing was thrown");
  EXPECT_EQ(
      complaint_of(with("MEAN_MOTION_DOT", "MEAN_MOTION_DOT = 2.1")),
      "orbit mean-elements message, line 25, column 19 (MEAN_MOTION_DOT): '2.1': not in [-2, 2] rev/day**2");
  EXPECT_EQ(complaint_of(with("MEAN_MOTION_DOT", "MEAN_MOTION_DOT = 1.99999998")), "nothing was thrown");
  EXPECT_THROW(Message::parse(with("MEAN_MOTION_DDOT", "MEAN_MOTION_DDOT = -7")), BadInput);
  EXPECT_THROW(Message::parse(with("MEAN_MOTION_DDOT", "MEAN_MOTION_DDOT = nan")), BadInput);
  EXPECT_NE(complaint_of(with("MEAN_MOTION ", "MEAN_MOTION = 15.49 [rad/s]")).find("the unit is [rev/day]"),
            std::string::npos);
  EXPECT_NE(complaint_of(with("BSTAR", "BSTAR = 1e-4 [1/m]")).find("the unit is [1/ER]"), std::string::npos);
  for (const char* wrong :
       {"", "nan", "inf", "1e999", "0x1p3", "1,5", "1.5.", "1.5 2", "1.5D0", "]", "1 [deg", "[deg] 1"}) {
    EXPECT_THROW(Message::parse(with("MEAN_ANOMALY", "MEAN_ANOMALY = " + std::string{wrong})), BadInput)
        << wrong;
    EXPECT_THROW(Message::parse(with("BSTAR", "BSTAR = " + std::string{wrong})), BadInput) << wrong;
  }
  for (const char* wrong : {"1", "-1e-9", "1e-3x"})
    EXPECT_THROW(Message::parse(with("ECCENTRICITY", "ECCENTRICITY = " + std::string{wrong})), BadInput)
        << wrong;
  for (const char* wrong : {"2026-02-30T00:00:00", "2026-07-21", "", "26202.18553447", "1950-01-01T00:00:00"})
    EXPECT_NE(complaint_of(with("EPOCH", "EPOCH = " + std::string{wrong})).find("line 12, column "),
              std::string::npos)
        << wrong;
  EXPECT_EQ(Message::parse(with("EPOCH", "EPOCH = 2026-202T04:27:10.178208Z")).epoch(),
            Message::parse(iss).epoch());
}

TEST(OrbitMeanElementsMessage, CatalogueNumbersOfAnySize) {
  const auto number = [](const std::string& written) {
    return Message::parse(with("NORAD_CAT_ID", "NORAD_CAT_ID = " + written)).catalogue_number();
  };
  EXPECT_EQ(number("5"), 5);
  EXPECT_EQ(number("340000"), 340000);
  EXPECT_EQ(number("799500123"), 799500123);
  for (const char* wrong : {"", "-5", "A0000", "5.0", "99999999999999999999"})
    EXPECT_THROW(number(wrong), BadInput) << wrong;
  EXPECT_EQ(Message::parse(with("NORAD_CAT_ID", "")).catalogue_number(), std::nullopt);
}

TEST(OrbitMeanElementsMessage, KeywordsOfTheStandardAndOthers) {
  const auto more =
      Message::parse(iss + "MASS = 420000 [kg]\nCOV_REF_FRAME = TEME\nCX_X = 1\nCZ_DOT_Y = 2\n" +
                     "USER_DEFINED_COLOUR = white\nUSER_DEFINED_BSTA = 1\nPROVIDER_GRADE = A [1]\n");
  EXPECT_EQ(*more.text("MASS"), "420000 [kg]");
  EXPECT_EQ(*more.text("USER_DEFINED_COLOUR"), "white");
  EXPECT_EQ(*more.text("USER_DEFINED_BSTA"), "1");
  EXPECT_EQ(*more.text("PROVIDER_GRADE"), "A [1]");
  EXPECT_EQ(Message::parse(with("OBJECT_NAME", "OBJECT_NAME = STARLINK-11262 [DTC]")).object_name(),
            "STARLINK-11262 [DTC]");
  EXPECT_EQ(complaint_of(iss + "INCLINATON = 51.6\n"),
            "orbit mean-elements message, line 27, column 14 (INCLINATON): '51.6': the keyword is not of the "
            "standard, but nearly INCLINATION");
  EXPECT_EQ(
      complaint_of(iss + "CX_Z = 2\n"),
      "orbit mean-elements message, line 27, column 8 (CX_Z): '2': the keyword is not of the standard, but "
      "nearly CX_X");
  EXPECT_EQ(
      complaint_of(iss + "PROVIDER_GRADE = A\nPROVIDER_GRADE = A\n"),
      "orbit mean-elements message, line 28, column 18 (PROVIDER_GRADE): 'A': the keyword is there for the "
      "second time, after line 27");
  EXPECT_EQ(complaint_of(iss + "BSTAR = 0\n"),
            "orbit mean-elements message, line 27, column 9 (BSTAR): '0': the keyword is there for the "
            "second time, "
            "after line 24");
  for (const char* keyword : {"OBJECT_NAME", "OBJECT_ID", "CENTER_NAME", "REF_FRAME", "TIME_SYSTEM",
                              "MEAN_ELEMENT_THEORY", "EPOCH", "MEAN_MOTION ", "ECCENTRICITY", "INCLINATION",
                              "RA_OF_ASC_NODE", "ARG_OF_PERICENTER", "MEAN_ANOMALY", "BSTAR"}) {
    std::string word{keyword};
    if (word.back() == ' ') word.pop_back();
    EXPECT_EQ(complaint_of(with(keyword, "")),
              "orbit mean-elements message, the message from line 1 on: there is no " + word);
  }
  for (const char* unused : {"CREATION_DATE", "ORIGINATOR", "EPHEMERIS_TYPE", "NORAD_CAT_ID"})
    EXPECT_NO_THROW(Message::parse(with(unused, ""))) << unused;
}

TEST(OrbitMeanElementsMessage, LinesThatAreNone) {
  EXPECT_EQ(complaint_of(with("BSTAR", "  BSTAR 1e-4")),
            "orbit mean-elements message, line 24, column 3: 'BSTAR 1e-4': expected keyword = value");
  EXPECT_EQ(complaint_of(with("BSTAR", "b* = 1e-4")),
            "orbit mean-elements message, line 24, column 1: 'b*' is no keyword");
  EXPECT_EQ(complaint_of(with("BSTAR", "= 1e-4")),
            "orbit mean-elements message, line 24, column 1: '' is no keyword");
  EXPECT_EQ(complaint_of(with("BSTAR", std::string("BSTAR = 1\0", 10))),
            "orbit mean-elements message, line 24, column 10: the byte 0 is no printable character of ASCII");
  EXPECT_NE(complaint_of(with("OBJECT_NAME", "OBJECT_NAME = Zar\xc3\xa4")).find("column 18: the byte 195"),
            std::string::npos);
  EXPECT_EQ(complaint_of("OBJECT_NAME = X\n" + iss),
            "orbit mean-elements message, line 1, column 15 (OBJECT_NAME): 'X': a message begins with "
            "CCSDS_OMM_VERS");
  EXPECT_EQ(complaint_of(""), "orbit mean-elements message: there is no message");
  EXPECT_EQ(complaint_of(iss + iss), "orbit mean-elements message: there are 2 messages");
}

// Cut inside its last number a message would still be one, of another B*.
TEST(OrbitMeanElementsMessage, ATruncatedFile) {
  const std::string cut = iss.substr(0, iss.find(".11479289E-3") + 5);
  EXPECT_EQ(*Message::parse(cut).text("BSTAR"), ".1147");
  const TemporaryFile file(cut);
  EXPECT_EQ(complaint([&] { Message::read(file.path()); }, file.path()),
            "orbit mean-elements message FILE, line 24: the file stops within this line; it was truncated");
}

TEST(OrbitMeanElementsMessage, FilesOfManyMessages) {
  const TemporaryFile file("\xEF\xBB\xBF" + iss + "\r\n" + with("NORAD_CAT_ID", "NORAD_CAT_ID = 100001\r"));
  const auto messages = Message::read(file.path());
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].catalogue_number(), 25544);
  EXPECT_EQ(messages[1].catalogue_number(), 100001);
  const TemporaryFile wrong(iss + with("BSTAR", ""));
  EXPECT_EQ(complaint([&] { Message::read(wrong.path()); }, wrong.path()),
            "orbit mean-elements message FILE, the message from line 27 on: there is no BSTAR");
  EXPECT_EQ(complaint([] { Message::read("/no/such/file"); }),
            "orbit mean-elements message /no/such/file: cannot be read");
}

// The object is in the messages of SGP4.
TEST(OrbitMeanElementsMessage, NamesItsObject) {
  EXPECT_EQ(complaint([] { Sgp4<Ship>(Message::parse(iss), at_most(0.0 * si::hour)); }),
            "Sgp4(" + frame_name<Ship>() +
                "): ISS (ZARYA) 1998-067A, the longest age is 0 s; it must be positive and finite");
}

}  // namespace
}  // namespace vectrix::orbit_mean_elements_message_test
