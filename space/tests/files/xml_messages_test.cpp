#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include <vectrix/space.hpp>

#include "files/faults.hpp"
#include "files/replaced.hpp"
#include "files/xml_ephemeris_texts.hpp"
#include "files/xml_parameter_texts.hpp"
#include "temporary_file.hpp"

// Each message here is written twice, in XML and in keywords and values: they are the same message.
namespace vectrix::xml_messages_test {
namespace {

TEST(XmlMessages, AreTheSameAsInKeywords) {
  EXPECT_EQ(AttitudeEphemerisMessage::parse(attitude_xml).text(),
            AttitudeEphemerisMessage::parse(attitude_kvn).text());
  EXPECT_EQ(AttitudeEphemerisMessage::parse(rates_xml).text(),
            AttitudeEphemerisMessage::parse(rates_kvn).text());
  EXPECT_EQ(OrbitEphemerisMessage::parse(orbit_xml).text(), OrbitEphemerisMessage::parse(orbit_kvn).text());
  EXPECT_EQ(OrbitParameterMessage::parse(orbit_parameters_xml).text(),
            OrbitParameterMessage::parse(orbit_parameters_kvn).text());
  EXPECT_EQ(AttitudeParameterMessage::parse(attitude_parameters_xml).text(),
            AttitudeParameterMessage::parse(attitude_parameters_kvn).text());
  EXPECT_EQ(AttitudeParameterMessage::parse(newer_parameters_xml).text(),
            AttitudeParameterMessage::parse(newer_parameters_kvn).text());
  const auto elements = OrbitMeanElementsMessage::parse(elements_xml);
  EXPECT_EQ(elements.catalogue_number(), 25544);
  EXPECT_EQ(elements.mean_elements().eccentricity, .00068493);
  EXPECT_EQ(*elements.text("MEAN_MOTION"), "15.49071756 [rev/day]");
}

// The same elements with a prefix, <n:aem xmlns:n="...">.
std::string prefixed(const std::string& xml) {
  std::string text;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    text += xml[i];
    const std::size_t name = i + (xml.compare(i, 2, "</") == 0 ? 2 : 1);
    if (xml[i] != '<' || name >= xml.size() || !std::isalpha(static_cast<unsigned char>(xml[name]))) continue;
    const bool has_prefix =
        xml.substr(name, xml.find_first_of(" />", name) - name).find(':') != std::string::npos;
    text += xml.substr(i + 1, name - i - 1) + (has_prefix ? "" : "n:");
    i = name - 1;
  }
  const auto end = text.find_first_of(" >", text.find("<n:"));
  return text.insert(end, " xmlns:n=\"urn:ccsds:schema:ndmxml\"");
}

TEST(XmlMessages, ElementsMayHaveAPrefix) {
  EXPECT_EQ(AttitudeEphemerisMessage::parse(prefixed(attitude_xml)).text(),
            AttitudeEphemerisMessage::parse(attitude_kvn).text());
  EXPECT_EQ(OrbitEphemerisMessage::parse(prefixed(orbit_xml)).text(),
            OrbitEphemerisMessage::parse(orbit_kvn).text());
  EXPECT_EQ(AttitudeParameterMessage::parse(prefixed(attitude_parameters_xml)).text(),
            AttitudeParameterMessage::parse(attitude_parameters_kvn).text());
}

// Of 313 the first and the third turn have one attribute, so that their elements tell which is which.
TEST(XmlMessages, TurnsHaveTheirOrder) {
  const auto xml = [](const std::string& turns) {
    const auto begin = attitude_xml.find("<rotation1"), end = attitude_xml.find("</rotationAngles>");
    return replaced(replaced(attitude_xml, attitude_xml.substr(begin, end - begin), turns), ">312<", ">313<");
  };
  const std::string first = "<rotation1 angle=\"Z_ANGLE\">10</rotation1>",
                    second = "<rotation2 angle=\"X_ANGLE\">20</rotation2>",
                    third = "<rotation3 angle=\"Z_ANGLE\">-30</rotation3>",
                    expected = "attitude ephemeris message, line 54, column ";
  EXPECT_EQ(AttitudeEphemerisMessage::parse(xml(first + second + third)).text(),
            AttitudeEphemerisMessage::parse(replaced(attitude_kvn, "= 312", "= 313")).text());
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(xml(third + second + first)),
            expected + "14: <rotation3>: expected rotation1");
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(xml(first + third + second)),
            expected + "55: <rotation3>: expected rotation2");
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(xml(first + second + first)),
            expected + "96: <rotation1>: expected rotation3");
}

TEST(XmlMessages, FilesOfManyMeanElements) {
  const TemporaryFile file("<ndm>" + elements_xml + replaced(elements_xml, "25544", "100001") + "</ndm>");
  const auto messages = OrbitMeanElementsMessage::read(file.path());
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[1].catalogue_number(), 100001);
}

TEST(XmlMessages, ACombinedMessageHasEveryKind) {
  const std::string text =
      "<?xml version=\"1.0\"?>\n<ndm>\n<MESSAGE_ID>7</MESSAGE_ID>\n<COMMENT>of all</COMMENT>\n" + rates_xml +
      orbit_parameters_xml + newer_parameters_xml + elements_xml +
      replaced(orbit_xml, "<?xml version=\"1.0\"?>", "") +
      "<ocm version=\"3.0\"><body>anything</body></ocm>\n</ndm>\n";
  const auto message = NavigationDataMessage::parse(text);
  EXPECT_EQ(message.comments, (std::vector<std::string>{"MESSAGE_ID 7", "of all"}));
  ASSERT_EQ(message.attitude_ephemerides.size(), 1U);
  ASSERT_EQ(message.attitude_parameters.size(), 1U);
  ASSERT_EQ(message.orbit_ephemerides.size(), 1U);
  ASSERT_EQ(message.orbit_parameters.size(), 1U);
  ASSERT_EQ(message.orbit_mean_elements.size(), 1U);
  EXPECT_EQ(message.orbit_ephemerides[0].text(), OrbitEphemerisMessage::parse(orbit_kvn).text());
  ASSERT_EQ(message.unread.size(), 1U);
  EXPECT_EQ(message.unread[0].element, "ocm");
  const std::string before = text.substr(0, text.find("<ocm"));
  EXPECT_EQ(message.unread[0].line,
            1U + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')));

  const TemporaryFile file(text);
  EXPECT_EQ(NavigationDataMessage::read(file.path()).orbit_parameters.size(), 1U);
  EXPECT_EQ(complaint([&] { OrbitParameterMessage::read(file.path()); }, file.path()),
            "orbit parameter message FILE, line 5, column 2: <aem>: expected <opm>; NavigationDataMessage "
            "reads every "
            "kind");
  EXPECT_EQ(complaint([] { NavigationDataMessage::parse("CCSDS_OEM_VERS = 3.0\n"); }),
            "navigation data message: it is not XML");
  EXPECT_NE(complaint([&] {
              NavigationDataMessage::parse(replaced(text, "<Y>9.5E+04</Y>", "<Y>x</Y>"));
            }).find("(Y): 'x': not a finite number"),
            std::string::npos);
}

}  // namespace
}  // namespace vectrix::xml_messages_test
