#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include <vectrix/space.hpp>

#include "files/replaced.hpp"
#include "files/xml_ephemeris_texts.hpp"
#include "temporary_file.hpp"

// Messages that are written in XML, and read again.
namespace vectrix::xml_messages_test {
namespace {

std::string oldest_rates_kvn() {
  return replaced(replaced(replaced(replaced(rates_kvn, "VERS = 2.0", "VERS = 1.0"), "/ANGVEL", "/RATE"),
                           "ANGVEL_FRAME", "RATE_FRAME"),
                  "TIME_SYSTEM", "ATTITUDE_DIR = A2B\nQUATERNION_TYPE = LAST\nTIME_SYSTEM");
}

template <class Message> void expect_to_read_back(const std::string& kvn) {
  const auto message = Message::parse(kvn);
  EXPECT_EQ(Message::parse(message.xml()).text(), message.text());
  const std::filesystem::path file = temporary_path(".xml");
  message.write(file);
  EXPECT_EQ(Message::read(file).xml(), message.xml());
  std::filesystem::remove(file);
}

TEST(XmlMessages, WrittenReadBackToTheLastDigit) {
  const std::string derivative = replaced(
      replaced(rates_kvn, "/ANGVEL\nANGVEL_FRAME = REF_FRAME_B", "/DERIVATIVE"), "1 1 2 3", "1 .1 .2 .3 0");
  const std::string oldest_derivative =
      replaced(replaced(attitude_kvn, "= QUATERNION\n", "= QUATERNION/DERIVATIVE\n"),
               "2021-04-15T13:31:20.0 .8 .6 0 0\n2021-04-15T13:31:21.0 .8 0 .6 0",
               "2021-04-15T13:31:20.0 .8 .6 0 0 1 2 3 4");
  for (const std::string& text : {attitude_kvn, rates_kvn, oldest_rates_kvn(), derivative, oldest_derivative,
                                  replaced(attitude_kvn, "312", "ZXZ")})
    expect_to_read_back<AttitudeEphemerisMessage>(text);
  const std::string second = orbit_kvn.substr(orbit_kvn.find("META_START"));
  for (const std::string& text : {orbit_kvn, orbit_kvn + second,
                                  replaced(orbit_kvn, "COVARIANCE_STOP",
                                           "EPOCH = 2007-09-14T10:43:01\n1\n2 3\n4 5 6\n7 8 9 10\n11 12 13 "
                                           "14 15\n16 17 18 19 20 21\nCOVARIANCE_STOP")})
    expect_to_read_back<OrbitEphemerisMessage>(text);
  EXPECT_EQ(
      complaint([] {
        static_cast<void>(OrbitEphemerisMessage::parse(replaced(orbit_kvn, "of the data", "\xE4")).xml());
      }),
      "orbit ephemeris message: the comment '\xE4' is not UTF-8");
}

TEST(XmlMessages, AreWrittenAsTheStandardHasThem) {
  EXPECT_EQ(
      AttitudeEphemerisMessage::parse(replaced(oldest_rates_kvn(), "ORIGINATOR =", "ORIGINATOR = A & B <C>"))
          .xml(),
      R"(<?xml version="1.0" encoding="UTF-8"?>
<aem id="CCSDS_AEM_VERS" version="1.0">
<header>
<CREATION_DATE></CREATION_DATE>
<ORIGINATOR>A &amp; B &lt;C&gt;</ORIGINATOR>
</header>
<body>
<segment><metadata>
<OBJECT_NAME>A</OBJECT_NAME>
<OBJECT_ID>B</OBJECT_ID>
<REF_FRAME_A>GCRF</REF_FRAME_A>
<REF_FRAME_B>BODY</REF_FRAME_B>
<ATTITUDE_DIR>A2B</ATTITUDE_DIR>
<TIME_SYSTEM>UTC</TIME_SYSTEM>
<START_TIME>2021-04-15T13:31:20.000</START_TIME>
<STOP_TIME>2021-04-15T13:31:20.000</STOP_TIME>
<ATTITUDE_TYPE>QUATERNION/RATE</ATTITUDE_TYPE>
<QUATERNION_TYPE>LAST</QUATERNION_TYPE>
<RATE_FRAME>REF_FRAME_B</RATE_FRAME>
</metadata>
<data>
<attitudeState><quaternionEulerRate><EPOCH>2021-04-15T13:31:20.000</EPOCH>
<quaternion><Q1>0.0e+00</Q1>
<Q2>0.0e+00</Q2>
<Q3>0.0e+00</Q3>
<QC>1.0e+00</QC>
</quaternion><rotationRates><rotation1 rate="X_RATE" units="deg/s">1.0e+00</rotation1>
<rotation2 rate="Y_RATE" units="deg/s">2.0e+00</rotation2>
<rotation3 rate="Z_RATE" units="deg/s">3.0e+00</rotation3>
</rotationRates></quaternionEulerRate></attitudeState>
</data></segment>
</body>
</aem>
)");
}

}  // namespace
}  // namespace vectrix::xml_messages_test
