#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "files/faults.hpp"
#include "files/replaced.hpp"
#include "files/xml_ephemeris_texts.hpp"
#include "files/xml_parameter_texts.hpp"
#include "temporary_file.hpp"

// The bytes of a file in XML, and the documents that are none of a message.
namespace vectrix::xml_messages_test {
namespace {

std::string in_utf16(const std::string& ascii, bool is_little) {
  std::string text = is_little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) text += is_little ? std::string{c, '\0'} : std::string{'\0', c};
  return text;
}

TEST(XmlMessages, InUtf16WithAMark) {
  const std::string text = replaced(rates_xml, "<aem", "<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n<aem");
  for (const bool is_little : {false, true}) {
    const TemporaryFile file(in_utf16(text, is_little));
    EXPECT_EQ(AttitudeEphemerisMessage::read(file.path()).text(),
              AttitudeEphemerisMessage::parse(rates_kvn).text());
  }
  // A pair of units is one character.
  std::string pair = in_utf16(replaced(text, "<CREATION", "<COMMENT>*</COMMENT><CREATION"), true);
  pair.replace(pair.find('*'), 2, "\x3D\xD8\x00\xDE", 4);
  EXPECT_EQ(AttitudeEphemerisMessage::parse(pair).header().comments,
            std::vector<std::string>{"\xF0\x9F\x98\x80"});
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(in_utf16("<a/>", true) + "\x3D"),
            "attitude ephemeris message: it is no UTF-16 at byte 10");
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(in_utf16("<a>", true) + std::string("\x3D\xD8<\0", 4)),
            "attitude ephemeris message: it is no UTF-16 at byte 8");
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(text),
            "attitude ephemeris message, line 1, column 3: <xml>: the encoding is 'UTF-16'; UTF-8 is read, "
            "and UTF-16 "
            "with its mark");
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(in_utf16(attitude_xml, true)),
            "attitude ephemeris message, line 1, column 3: <xml>: the encoding is 'UTF-8'; the mark of the "
            "file is that of "
            "UTF-16");
}

// A byte of Latin-1, a long form of a short one, half of a pair of UTF-16, and one above all of Unicode.
TEST(XmlMessages, OtherBytesThanOfUtf8AreRefused) {
  const auto of_comment = [](const std::string& bytes) {
    return complaint_of<AttitudeEphemerisMessage>(replaced(attitude_xml, "of the header", bytes));
  };
  for (const char* bytes : {"\xE4", "\x84", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80",
                            "\xF0\x80\x80\xAF", "\xF4\x90\x80\x80", "\xF8\x88\x80\x80", "\xFF"})
    EXPECT_EQ(of_comment(bytes), "attitude ephemeris message, line 4, column 14: the byte " +
                                     std::to_string(int{static_cast<unsigned char>(*bytes)}) +
                                     " is not of UTF-8");
  for (const char* bytes : {"\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                            "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(of_comment(bytes), "nothing was thrown") << bytes;
}

// Orekit has this file (at fe4aee84, Apache-2.0) to show that it can be parsed; it is no message.
TEST(XmlMessages, OtherDocumentsAreRefused) {
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(in_utf16(
                "<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n<greeting>Hello, world!</greeting>\n", true)),
            "attitude ephemeris message, line 2, column 2: <greeting>: expected <aem>");
  EXPECT_EQ(complaint_of<OrbitEphemerisMessage>(attitude_xml),
            "orbit ephemeris message, line 2, column 2: <aem>: expected <oem>");
  EXPECT_EQ(complaint_of<OrbitMeanElementsMessage>("<ndm>" + elements_xml + elements_xml + "</ndm>"),
            "orbit mean-elements message: there are 2 messages");
  EXPECT_EQ(complaint_of<OrbitEphemerisMessage>(in_utf16(orbit_kvn, true)),
            "orbit ephemeris message, line 1, column 1: UTF-16, but not XML");
  EXPECT_EQ(complaint_of<OrbitEphemerisMessage>("\n <?xml version=\"1.0\"?>\n"),
            "orbit ephemeris message, line 3, column 1: it is not well-formed: No document element found");
  EXPECT_EQ(complaint_of<OrbitEphemerisMessage>("<ndm></ndm>"),
            "orbit ephemeris message: there is no message");
}

// Elements within elements, as many as fit: no stack is used up.
TEST(XmlMessages, DeepDocumentsAreRefused) {
  constexpr int levels = 200000;
  std::string deep, end;
  for (int i = 0; i < levels; ++i) deep += "<a>";
  for (int i = 0; i < levels; ++i) end += "</a>";
  EXPECT_EQ(complaint_of<AttitudeEphemerisMessage>(deep + end),
            "attitude ephemeris message, line 1, column 2: <a>: expected <aem>");
  EXPECT_NE(complaint_of<AttitudeEphemerisMessage>(
                replaced(attitude_xml, "<quaternion>", "<quaternion>" + deep + end)),
            "nothing was thrown");
  EXPECT_NE(complaint_of<AttitudeEphemerisMessage>(replaced(attitude_xml, "ORBITER", deep + end)),
            "nothing was thrown");
}

}  // namespace
}  // namespace vectrix::xml_messages_test
