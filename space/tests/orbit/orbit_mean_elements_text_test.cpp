#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <vectrix/space/files/navigation_data_message.hpp>
#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>
#include <vectrix/space/orbit/two_line_elements.hpp>

#include "orbit/check_sum.hpp"
#include "temporary_file.hpp"

namespace vectrix::orbit_mean_elements_text_test {
namespace {

using Message = OrbitMeanElementsMessage;

const MessageHeader header{"3.0", "2026-11-29T00:00:00", "TEST"};

// All that a message may have, in an order that is not that of the standard.
const std::string full = R"(CCSDS_OMM_VERS = 3.0
COMMENT of the header: µ < & >
ORIGINATOR = A [B] & CO
CREATION_DATE = 2026-07-21
MESSAGE_ID = 1/2
COMMENT of the metadata
COMMENT of two lines
OBJECT_NAME = STARLINK-11262 [DTC]
OBJECT_ID = 1998-067A
CENTER_NAME = EARTH
REF_FRAME = TEME
TIME_SYSTEM = UTC
MEAN_ELEMENT_THEORY = SGP/SGP4
BSTAR = .11479289E-3 [1/ER]
EPOCH = 2026-202T04:27:10.178208Z
USER_DEFINED_COLOUR = white [1] & <black>
MEAN_MOTION = 15.49071756 [rev/day]
ECCENTRICITY = .00068493
INCLINATION = 051.6316 [deg]
RA_OF_ASC_NODE = 131.8443
ARG_OF_PERICENTER = 320.6461
MEAN_ANOMALY = 39.4029
GM = 398600.8 [km**3/s**2]
PROVIDER_GRADE = A [1]
MASS = 420000 [kg]
EPHEMERIS_TYPE = 0
CLASSIFICATION_TYPE = U
NORAD_CAT_ID = 799500123
MEAN_MOTION_DOT = .5896E-4
COV_REF_FRAME = TEME
CX_X = 1 [km**2]
COMMENT at the end
)";

void expect_same(const Message& a, const Message& b) {
  EXPECT_EQ(a.values(), b.values());
  for (const auto& [keyword, value] : a.values()) {
    const auto *of_a = a.comments(keyword), *of_b = b.comments(keyword);
    ASSERT_EQ(of_a != nullptr, of_b != nullptr) << keyword;
    if (of_a) {
      EXPECT_EQ(*of_a, *of_b) << keyword;
    }
  }
  ASSERT_TRUE(a.comments("") && b.comments(""));
  EXPECT_EQ(*a.comments(""), *b.comments(""));
}

TEST(OrbitMeanElementsText, KeepsEveryValueAsItWasWritten) {
  const Message message = Message::parse(full);
  const std::string text = message.text();
  expect_same(Message::parse(text), message);
  EXPECT_EQ(Message::parse(text).text(), text);
  expect_same(Message::parse(message.xml()), message);
  EXPECT_EQ(Message::parse(message.xml()).text(), text);
  // Units that are not written as the standard does.
  for (const char* mass :
       {"3[kg]", "3  [kg]", "3 [k\"g]", "3 [<kg>]", "3 [ kg ]", "[kg]", "3 [a] [b]", "]", "3 []"}) {
    const Message other = message.with("MASS", mass);
    EXPECT_EQ(*Message::parse(other.xml()).text("MASS"), mass);
  }
  // In the order of the standard.
  std::size_t before = 0;
  for (const char* line : {"CCSDS_OMM_VERS = 3.0\nCOMMENT of the header", "ORIGINATOR", "MESSAGE_ID",
                           "COMMENT of two lines\nOBJECT_NAME", "MEAN_ELEMENT_THEORY", "EPOCH", "GM", "MASS",
                           "EPHEMERIS_TYPE", "BSTAR = .11479289E-3 [1/ER]\nMEAN_MOTION_DOT", "COV_REF_FRAME",
                           "PROVIDER_GRADE", "COMMENT at the end"}) {
    const std::size_t at = text.find(line);
    ASSERT_NE(at, std::string::npos) << line;
    EXPECT_LE(before, at) << line;
    before = at;
  }
}

TEST(OrbitMeanElementsText, MayHaveAnotherValue) {
  const Message message = Message::parse(full);
  auto values = message.values();
  values["OBJECT_NAME"] = "Y";
  values["ELEMENT_SET_NO"] = "7";
  EXPECT_EQ(message.with("OBJECT_NAME", "Y").with("ELEMENT_SET_NO", "7").values(), values);
  EXPECT_NE(complaint([&] { static_cast<void>(message.with("BSTAR", "x")); }).find("BSTAR"),
            std::string::npos);
  EXPECT_NE(complaint([&] { static_cast<void>(message.with("OBJECT_NAME", "a\nb")); }).find("one line"),
            std::string::npos);
}

// The elements of the standard: 502.0-B and 505.0-B.
TEST(OrbitMeanElementsText, HasTheElementsOfTheStandard) {
  const std::string xml = Message::parse(full).xml();
  for (const char* part :
       {"<omm id=\"CCSDS_OMM_VERS\" version=\"3.0\">\n<header>\n", "</header>\n<body><segment>\n<metadata>\n",
        "</metadata>\n<data>\n<meanElements>\n<EPOCH>",
        "<MEAN_MOTION units=\"rev/day\">15.49071756</MEAN_MOTION>",
        "</meanElements>\n<spacecraftParameters>\n<MASS units=\"kg\">420000</MASS>",
        "</spacecraftParameters>\n<tleParameters>\n", "</tleParameters>\n<covarianceMatrix>\n",
        "<userDefinedParameters>\n<USER_DEFINED parameter=\"COLOUR\">white [1] &amp; "
        "&lt;black&gt;</USER_DEFINED>\n"
        "</userDefinedParameters>\n",
        "<ORIGINATOR>A [B] &amp; CO</ORIGINATOR>", "<COMMENT>of the header: µ &lt; &amp; &gt;</COMMENT>",
        "</data>\n</segment></body>\n</omm>\n"})
    EXPECT_NE(xml.find(part), std::string::npos) << part << xml;
}

void expect_same_bits(double a, double b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b));
}

TEST(OrbitMeanElementsText, OfTwoLinesHasTheirElementsToTheLastBit) {
  const auto file = std::filesystem::path{VECTRIX_SOURCE_DIR} / "space/tests/data/sgp4_sets.tle";
  const auto sets = TwoLineElements::read(file);
  ASSERT_FALSE(sets.empty());
  for (const TwoLineElements& set : sets) {
    const Message message(header, set);
    for (const Message& read : {message, Message::parse(message.text()), Message::parse(message.xml())}) {
      const MeanElements &x = read.mean_elements(), &expected = set.mean_elements();
      constexpr double of_a_day = 2e-11;  // s, the rounding of its fraction
      EXPECT_NEAR((x.epoch - expected.epoch).value(), 0.0, of_a_day);
      expect_same_bits(x.mean_motion.value(), expected.mean_motion.value());
      expect_same_bits(x.eccentricity, expected.eccentricity);
      expect_same_bits(x.inclination.value(), expected.inclination.value());
      expect_same_bits(x.ascending_node.value(), expected.ascending_node.value());
      expect_same_bits(x.argument_of_perigee.value(), expected.argument_of_perigee.value());
      expect_same_bits(x.mean_anomaly.angle.value(), expected.mean_anomaly.angle.value());
      expect_same_bits(x.bstar.value(), expected.bstar.value());
      EXPECT_EQ(read.catalogue_number(), set.catalogue_number());
    }
  }
}

// Digit by digit what is in the lines.
TEST(OrbitMeanElementsText, OfTwoLinesHasTheirDigits) {
  const auto set = TwoLineElements::parse(
      "ISS", summed("1 25544U 98067A   08264.51782528 -.00002182  12345-9 -11606-4 0  292"),
      summed("2 25544  51.6416 247.4627 0006703 130.5360 325.0288 15.72125391563537"));
  const Message message(header, set);
  const auto is = [&](const char* keyword, const std::string& expected) {
    ASSERT_TRUE(message.text(keyword)) << keyword;
    EXPECT_EQ(*message.text(keyword), expected) << keyword;
  };
  is("OBJECT_NAME", "ISS");
  is("OBJECT_ID", "1998-067A");
  is("EPOCH", "2008-09-20T12:25:40.104192");
  is("MEAN_MOTION", "15.72125391");
  is("ECCENTRICITY", "0.0006703");
  is("INCLINATION", "51.6416");
  is("MEAN_ANOMALY", "325.0288");
  is("NORAD_CAT_ID", "25544");
  is("CLASSIFICATION_TYPE", "U");
  is("ELEMENT_SET_NO", "292");
  is("REV_AT_EPOCH", "56353");
  is("BSTAR", "-1.1606e-05");
  is("MEAN_MOTION_DOT", "-2.182e-05");
  is("MEAN_MOTION_DDOT", "1.2345e-10");
}

TEST(OrbitMeanElementsText, OfElementsRefusesWhatCannotBeRead) {
  const MeanElements elements = Message::parse(full).mean_elements();
  const auto refused = [&](const MessageHeader& of, const std::string& name,
                           const std::vector<OtherKeyword>& more) {
    return complaint([&] { Message(of, name, "", elements, more); });
  };
  EXPECT_EQ(refused(header, "X", {{"NORAD_CAT_ID", "5"}}), "nothing was thrown");
  EXPECT_EQ(refused({"1.0", "", ""}, "X", {}),
            "orbit mean-elements message: the version is '1.0'; the versions are 2.0, 3.0");
  EXPECT_EQ(
      refused(header, "X\nBSTAR = 0", {}),
      "orbit mean-elements message: OBJECT_NAME 'X\nBSTAR = 0' is not one line of printable ASCII without "
      "blanks around it");
  EXPECT_EQ(refused(header, "X", {{"colour", "5"}}),
            "orbit mean-elements message: 'colour': a keyword is of A-Z, 0-9 and _");
  EXPECT_NE(refused(header, "X", {{"BSTAR", "5"}}).find("for the second time"), std::string::npos);
  EXPECT_NE(refused(header, "X", {{"NORAD_CAT_ID", "-5"}}).find("NORAD_CAT_ID"), std::string::npos);
}

TEST(OrbitMeanElementsText, SeveralAreAFile) {
  const Message first = Message::parse(full),
                second(header, "B", "", first.mean_elements(), {{"NORAD_CAT_ID", "5"}});
  const auto folder = std::filesystem::temp_directory_path();
  for (const char* name : {"vectrix_several.omm", "vectrix_several.xml"}) {
    Message::write(folder / name, {first, second});
    const auto read = Message::read(folder / name);
    ASSERT_EQ(read.size(), 2U) << name;
    EXPECT_EQ(read[0].values(), first.values());
    EXPECT_EQ(read[1].values(), second.values());
    second.write(folder / name);
    EXPECT_EQ(Message::read(folder / name).size(), 1U);
    std::filesystem::remove(folder / name);
  }
  EXPECT_EQ(NavigationDataMessage::parse(Message::text_of({first, second}, true)).orbit_mean_elements.size(),
            2U);
  EXPECT_EQ(complaint([] { static_cast<void>(Message::text_of({}, true)); }),
            "orbit mean-elements message: there are no messages to be written");
}

}  // namespace
}  // namespace vectrix::orbit_mean_elements_text_test
