#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>

#include <vectrix/space.hpp>

#include "files/replaced.hpp"
#include "temporary_file.hpp"

// Each message here is written twice, in XML and in keywords and values: they are the same message.
namespace vectrix::xml_messages_test {
namespace {

const std::string attitude_xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<aem xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" id="CCSDS_AEM_VERS" version="1.0">
  <header>
    <COMMENT>of the header: a &lt; b &amp; "c", &#956;</COMMENT>
    <CREATION_DATE>2026-01-02T03:04:05</CREATION_DATE>
    <ORIGINATOR><![CDATA[HERE & THERE]]></ORIGINATOR>
  </header>
  <body>
    <segment>
      <metadata>
        <COMMENT>of two
                 lines</COMMENT>
        <OBJECT_NAME>ORBITER</OBJECT_NAME>
        <OBJECT_ID/>
        <REF_FRAME_A>LVLH</REF_FRAME_A>
        <REF_FRAME_B>IMU_FRAME_1</REF_FRAME_B>
        <ATTITUDE_DIR>B2A</ATTITUDE_DIR>
        <TIME_SYSTEM>TAI</TIME_SYSTEM>
        <START_TIME>2021-04-15T13:31:20.0</START_TIME>
        <STOP_TIME>2021-04-15T13:31:23.0</STOP_TIME>
        <ATTITUDE_TYPE>QUATERNION</ATTITUDE_TYPE>
        <QUATERNION_TYPE>FIRST</QUATERNION_TYPE>
        <MISSION_PHASE>cruise</MISSION_PHASE>
      </metadata>
      <data>
        <COMMENT>of the data</COMMENT>
        <attitudeState><quaternionState>
          <EPOCH>2021-04-15T13:31:20.0</EPOCH>
          <quaternion><Q1>0.6</Q1><Q2>0</Q2><Q3>.0</Q3><QC>+8e-001</QC></quaternion>
        </quaternionState></attitudeState>
        <attitudeState><quaternionState>
          <EPOCH>2021-105T13:31:21</EPOCH>
          <quaternion><QC>0.8</QC><Q1>0</Q1><Q2>0.6</Q2><Q3> 0 </Q3></quaternion>
        </quaternionState></attitudeState>
      </data>
    </segment>
    <segment>
      <metadata>
        <OBJECT_NAME>ORBITER</OBJECT_NAME>
        <OBJECT_ID></OBJECT_ID>
        <REF_FRAME_A>EME2000</REF_FRAME_A>
        <REF_FRAME_B>SC_BODY_1</REF_FRAME_B>
        <ATTITUDE_DIR>A2B</ATTITUDE_DIR>
        <TIME_SYSTEM>TAI</TIME_SYSTEM>
        <START_TIME>2021-04-15T13:31:24.0</START_TIME>
        <STOP_TIME>2021-04-15T13:31:25.0</STOP_TIME>
        <ATTITUDE_TYPE>EULER_ANGLE</ATTITUDE_TYPE>
        <EULER_ROT_SEQ>312</EULER_ROT_SEQ>
      </metadata>
      <data>
        <attitudeState><eulerAngle>
          <EPOCH>2021-04-15T13:31:24.0</EPOCH>
          <rotationAngles>
            <rotation1 angle="Z_ANGLE" units="deg">10</rotation1>
            <rotation2 angle="X_ANGLE" units="deg">20</rotation2>
            <rotation3 angle="Y_ANGLE" units="DEG">-30</rotation3>
          </rotationAngles>
        </eulerAngle></attitudeState>
      </data>
    </segment>
  </body>
</aem>
)";
const std::string attitude_kvn = R"(CCSDS_AEM_VERS = 1.0
COMMENT of the header: a < b & "c", )"
                                 "\xCE\xBC"
                                 R"(
CREATION_DATE = 2026-01-02T03:04:05
ORIGINATOR = HERE & THERE
META_START
COMMENT of two
COMMENT lines
OBJECT_NAME = ORBITER
OBJECT_ID =
REF_FRAME_A = LVLH
REF_FRAME_B = IMU_FRAME_1
ATTITUDE_DIR = B2A
TIME_SYSTEM = TAI
START_TIME = 2021-04-15T13:31:20.0
STOP_TIME = 2021-04-15T13:31:23.0
ATTITUDE_TYPE = QUATERNION
QUATERNION_TYPE = FIRST
MISSION_PHASE = cruise
META_STOP
DATA_START
COMMENT of the data
2021-04-15T13:31:20.0 .8 .6 0 0
2021-04-15T13:31:21.0 .8 0 .6 0
DATA_STOP
META_START
OBJECT_NAME = ORBITER
OBJECT_ID =
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ATTITUDE_DIR = A2B
TIME_SYSTEM = TAI
START_TIME = 2021-04-15T13:31:24.0
STOP_TIME = 2021-04-15T13:31:25.0
ATTITUDE_TYPE = EULER_ANGLE
EULER_ROT_SEQ = 312
META_STOP
DATA_START
2021-04-15T13:31:24.0 10 20 -30
DATA_STOP
)";

const std::string rates_xml =
    R"(<aem version="2.0"><header><CREATION_DATE/><ORIGINATOR/></header><body><segment>
<metadata><OBJECT_NAME>A</OBJECT_NAME><OBJECT_ID>B</OBJECT_ID><REF_FRAME_A>GCRF</REF_FRAME_A>
<REF_FRAME_B>BODY</REF_FRAME_B><TIME_SYSTEM>UTC</TIME_SYSTEM><START_TIME>2021-04-15T13:31:20</START_TIME>
<STOP_TIME>2021-04-15T13:31:20</STOP_TIME><ATTITUDE_TYPE>QUATERNION/ANGVEL</ATTITUDE_TYPE>
<ANGVEL_FRAME>REF_FRAME_B</ANGVEL_FRAME></metadata>
<data><attitudeState><quaternionAngVel><EPOCH>2021-04-15T13:31:20</EPOCH>
<quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion>
<angVel><ANGVEL_X units="deg/s">1</ANGVEL_X><ANGVEL_Y>2</ANGVEL_Y><ANGVEL_Z>3</ANGVEL_Z></angVel>
</quaternionAngVel></attitudeState></data></segment></body></aem>)";
const std::string rates_kvn = R"(CCSDS_AEM_VERS = 2.0
CREATION_DATE =
ORIGINATOR =
META_START
OBJECT_NAME = A
OBJECT_ID = B
REF_FRAME_A = GCRF
REF_FRAME_B = BODY
TIME_SYSTEM = UTC
START_TIME = 2021-04-15T13:31:20
STOP_TIME = 2021-04-15T13:31:20
ATTITUDE_TYPE = QUATERNION/ANGVEL
ANGVEL_FRAME = REF_FRAME_B
META_STOP
DATA_START
2021-04-15T13:31:20 0 0 0 1 1 2 3
DATA_STOP
)";

// The covariance of the lower triangle 1, 2, ..., 21.
std::string covariance_xml() {
  std::string text;
  int number = 0;
  const char* const names[] = {"X", "Y", "Z", "X_DOT", "Y_DOT", "Z_DOT"};
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column <= row; ++column) {
      const std::string name = std::string{"C"} + names[row] + "_" + names[column];
      text += "<" + name + ">" + std::to_string(++number) + "</" + name + ">\n";
    }
  }
  return text;
}

const std::string orbit_xml = R"(<?xml version="1.0"?>
<ndm:oem xmlns:ndm="urn:ccsds:schema:ndmxml" id="CCSDS_OEM_VERS" version="3.0">
<header><CREATION_DATE>2026-01-02T03:04:05</CREATION_DATE><ORIGINATOR>HERE</ORIGINATOR></header>
<body><segment><metadata>
<OBJECT_NAME>ORBITER</OBJECT_NAME><OBJECT_ID>1996-062A</OBJECT_ID>
<CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>EME2000</REF_FRAME><TIME_SYSTEM>UTC</TIME_SYSTEM>
<START_TIME>2007-09-14T10:43:00</START_TIME><STOP_TIME>2007-09-14T10:44:00</STOP_TIME>
<INTERPOLATION_DEGREE>7</INTERPOLATION_DEGREE>
</metadata><data>
<COMMENT>of the data</COMMENT>
<stateVector><EPOCH>2007-09-14T10:43:00</EPOCH>
<X units="km">1.336886031675458E+03</X><Y>9.5E+04</Y><Z>3.3E+04</Z>
<X_DOT units="km/s">-6.3E-01</X_DOT><Y_DOT>1.8</Y_DOT><Z_DOT>9.3E-01</Z_DOT></stateVector>
<stateVector><EPOCH>2007-09-14T10:44:00</EPOCH><X>1</X><Y>2</Y><Z>3</Z><X_DOT>4</X_DOT><Y_DOT>5</Y_DOT><Z_DOT>6</Z_DOT>
<X_DDOT units="km/s**2">7</X_DDOT><Y_DDOT>8</Y_DDOT><Z_DDOT>9</Z_DDOT></stateVector>
<covarianceMatrix><EPOCH>2007-09-14T10:43:00</EPOCH><COV_REF_FRAME>RTN</COV_REF_FRAME>
)" + covariance_xml() + R"(</covarianceMatrix>
</data></segment></body></ndm:oem>
)";
const std::string orbit_kvn = R"(CCSDS_OEM_VERS = 3.0
CREATION_DATE = 2026-01-02T03:04:05
ORIGINATOR = HERE
META_START
OBJECT_NAME = ORBITER
OBJECT_ID = 1996-062A
CENTER_NAME = EARTH
REF_FRAME = EME2000
TIME_SYSTEM = UTC
START_TIME = 2007-09-14T10:43:00
STOP_TIME = 2007-09-14T10:44:00
INTERPOLATION_DEGREE = 7
META_STOP
COMMENT of the data
2007-09-14T10:43:00 1336.886031675458 95000 33000 -.63 1.8 .93
2007-09-14T10:44:00 1 2 3 4 5 6 7 8 9
COVARIANCE_START
EPOCH = 2007-09-14T10:43:00
COV_REF_FRAME = RTN
1
2 3
4 5 6
7 8 9 10
11 12 13 14 15
16 17 18 19 20 21
COVARIANCE_STOP
)";

const std::string orbit_parameters_xml = R"(<opm id="CCSDS_OPM_VERS" version="3.0">
<header><COMMENT>of the header</COMMENT><CREATION_DATE>2009-05-18T13:06:00</CREATION_DATE>
<ORIGINATOR>NASA</ORIGINATOR></header>
<body><segment><metadata><OBJECT_NAME>SOHO</OBJECT_NAME><OBJECT_ID>2009-000A</OBJECT_ID>
<CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>EME2000</REF_FRAME><TIME_SYSTEM>UTC</TIME_SYSTEM></metadata>
<data><stateVector><COMMENT>of the state</COMMENT><EPOCH>2009-05-12T15:30:00</EPOCH>
<X units="km">7000</X><Y>0</Y><Z>0</Z><X_DOT>0</X_DOT><Y_DOT units="km/s">7.5</Y_DOT><Z_DOT>0</Z_DOT></stateVector>
<spacecraftParameters><MASS units="kg">1913</MASS><DRAG_AREA units="m**2">10</DRAG_AREA></spacecraftParameters>
<maneuverParameters><MAN_EPOCH_IGNITION>2009-05-12T15:30:00</MAN_EPOCH_IGNITION>
<MAN_DURATION units="s">0</MAN_DURATION><MAN_DELTA_MASS>-0.02</MAN_DELTA_MASS>
<MAN_REF_FRAME>EME2000</MAN_REF_FRAME><MAN_DV_1>1E-5</MAN_DV_1><MAN_DV_2>0</MAN_DV_2><MAN_DV_3>0</MAN_DV_3>
</maneuverParameters>
<userDefinedParameters><USER_DEFINED parameter="EARTH_MODEL">WGS-84</USER_DEFINED></userDefinedParameters>
</data></segment></body></opm>)";
const std::string orbit_parameters_kvn = R"(CCSDS_OPM_VERS = 3.0
COMMENT of the header
CREATION_DATE = 2009-05-18T13:06:00
ORIGINATOR = NASA
OBJECT_NAME = SOHO
OBJECT_ID = 2009-000A
CENTER_NAME = EARTH
REF_FRAME = EME2000
TIME_SYSTEM = UTC
COMMENT of the state
EPOCH = 2009-05-12T15:30:00
X = 7000 [km]
Y = 0
Z = 0
X_DOT = 0
Y_DOT = 7.5 [km/s]
Z_DOT = 0
MASS = 1913 [kg]
DRAG_AREA = 10 [m**2]
MAN_EPOCH_IGNITION = 2009-05-12T15:30:00
MAN_DURATION = 0 [s]
MAN_DELTA_MASS = -0.02
MAN_REF_FRAME = EME2000
MAN_DV_1 = 1E-5
MAN_DV_2 = 0
MAN_DV_3 = 0
USER_DEFINED_EARTH_MODEL = WGS-84
)";

// Versions 1.0 and 2.0 have other elements.
const std::string attitude_parameters_xml = R"(<apm id="CCSDS_APM_VERS" version="1.0">
<header><CREATION_DATE>2004-02-14T19:23:57</CREATION_DATE><ORIGINATOR>JPL</ORIGINATOR></header>
<body><segment><metadata><OBJECT_NAME>MARS SPIRIT</OBJECT_NAME><OBJECT_ID>2004-003A</OBJECT_ID>
<TIME_SYSTEM>UTC</TIME_SYSTEM></metadata><data>
<quaternionState><EPOCH>2004-02-14T14:28:15.1172</EPOCH><Q_FRAME_A>INSTRUMENT_A</Q_FRAME_A>
<Q_FRAME_B>ITRF-97</Q_FRAME_B><Q_DIR>A2B</Q_DIR>
<quaternion><Q1>0.6</Q1><Q2>0</Q2><Q3>0</Q3><QC>0.8</QC></quaternion></quaternionState>
<eulerElementsThree><EULER_FRAME_A>ITRF-97</EULER_FRAME_A><EULER_FRAME_B>INSTRUMENT_A</EULER_FRAME_B>
<EULER_DIR>A2B</EULER_DIR><EULER_ROT_SEQ>312</EULER_ROT_SEQ>
<rotationAngles><rotation1 angle="Z_ANGLE" units="deg">-53.3688</rotation1>
<rotation2 angle="X_ANGLE">139.7527</rotation2><rotation3 angle="Y_ANGLE">25.0658</rotation3></rotationAngles>
</eulerElementsThree></data></segment></body></apm>)";
const std::string attitude_parameters_kvn = R"(CCSDS_APM_VERS = 1.0
CREATION_DATE = 2004-02-14T19:23:57
ORIGINATOR = JPL
OBJECT_NAME = MARS SPIRIT
OBJECT_ID = 2004-003A
TIME_SYSTEM = UTC
EPOCH = 2004-02-14T14:28:15.1172
Q_FRAME_A = INSTRUMENT_A
Q_FRAME_B = ITRF-97
Q_DIR = A2B
Q1 = 0.6
Q2 = 0
Q3 = 0
QC = 0.8
EULER_FRAME_A = ITRF-97
EULER_FRAME_B = INSTRUMENT_A
EULER_DIR = A2B
EULER_ROT_SEQ = 312
Z_ANGLE = -53.3688 [deg]
X_ANGLE = 139.7527
Y_ANGLE = 25.0658
)";
const std::string newer_parameters_xml = R"(<apm id="CCSDS_APM_VERS" version="2.0">
<header><CREATION_DATE>2023-02-03T12:00:00</CREATION_DATE><ORIGINATOR>HERE</ORIGINATOR></header>
<body><segment><metadata><OBJECT_NAME>A</OBJECT_NAME><OBJECT_ID>B</OBJECT_ID><TIME_SYSTEM>TAI</TIME_SYSTEM></metadata>
<data><EPOCH>2023-01-01T00:00:00</EPOCH>
<quaternionState><REF_FRAME_A>EME2000</REF_FRAME_A><REF_FRAME_B>SC_BODY_1</REF_FRAME_B>
<quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion></quaternionState>
<angularVelocity><REF_FRAME_A>EME2000</REF_FRAME_A><REF_FRAME_B>SC_BODY_1</REF_FRAME_B>
<ANGVEL_FRAME>SC_BODY_1</ANGVEL_FRAME><ANGVEL_X units="deg/s">1</ANGVEL_X><ANGVEL_Y>2</ANGVEL_Y>
<ANGVEL_Z>3</ANGVEL_Z></angularVelocity></data></segment></body></apm>)";
const std::string newer_parameters_kvn = R"(CCSDS_APM_VERS = 2.0
CREATION_DATE = 2023-02-03T12:00:00
ORIGINATOR = HERE
OBJECT_NAME = A
OBJECT_ID = B
TIME_SYSTEM = TAI
EPOCH = 2023-01-01T00:00:00
QUAT_START
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
Q1 = 0
Q2 = 0
Q3 = 0
QC = 1
QUAT_STOP
ANGVEL_START
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ANGVEL_FRAME = SC_BODY_1
ANGVEL_X = 1 [deg/s]
ANGVEL_Y = 2
ANGVEL_Z = 3
ANGVEL_STOP
)";

// The figures of open-space-collective/ccsds-data-messages (at d934e096, Apache-2.0).
const std::string elements_xml = R"(<omm id="CCSDS_OMM_VERS" version="3.0">
<header><CREATION_DATE/><ORIGINATOR/></header><body><segment><metadata><OBJECT_NAME>ISS (ZARYA)</OBJECT_NAME>
<OBJECT_ID>1998-067A</OBJECT_ID><CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>TEME</REF_FRAME>
<TIME_SYSTEM>UTC</TIME_SYSTEM><MEAN_ELEMENT_THEORY>SGP4</MEAN_ELEMENT_THEORY></metadata><data>
<meanElements><EPOCH>2026-07-21T04:27:10.178208</EPOCH><MEAN_MOTION units="rev/day">15.49071756</MEAN_MOTION>
<ECCENTRICITY>.00068493</ECCENTRICITY><INCLINATION>51.6316</INCLINATION><RA_OF_ASC_NODE>131.8443</RA_OF_ASC_NODE>
<ARG_OF_PERICENTER>320.6461</ARG_OF_PERICENTER><MEAN_ANOMALY>39.4029</MEAN_ANOMALY></meanElements>
<tleParameters><NORAD_CAT_ID>25544</NORAD_CAT_ID><BSTAR>.11479289E-3</BSTAR></tleParameters>
</data></segment></body></omm>)";

template <class Message> std::string complaint_of(const std::string& text) {
  return complaint([&] { Message::parse(text); });
}
std::string in_utf16(const std::string& ascii, bool is_little) {
  std::string text = is_little ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) text += is_little ? std::string{c, '\0'} : std::string{'\0', c};
  return text;
}

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

struct Fault {
  const std::string& text;
  std::string old, by, reason;
};
template <class Message> void expect_faults(std::initializer_list<Fault> faults, const std::string& kind) {
  for (const auto& [text, old, by, reason] : faults)
    EXPECT_EQ(complaint_of<Message>(replaced(text, old, by)), kind + ", " + reason) << by;
}

// A document type can read files and grow without end; there is none in a message.
TEST(XmlMessages, DocumentTypesAndEntitiesAreRefused) {
  const std::string refused = "a document type; it can name other files and entities, and is refused";
  expect_faults<AttitudeEphemerisMessage>(
      {{attitude_xml, "<aem xmlns", "<!DOCTYPE aem SYSTEM \"file:///etc/passwd\">\n<aem xmlns",
        "line 2, column 11: " + refused},
       {attitude_xml, "<aem xmlns",
        "<!DOCTYPE a [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;\"><!ENTITY c \"&b;&b;&b;\">]><aem xmlns",
        "line 2, column 11: " + refused},
       {attitude_xml, "<aem xmlns", "<!DOCTYPE a [<!ENTITY x \"<aem xmlns",
        "line 2, column 1: a document type, which is refused"},
       {attitude_xml, "ORBITER", "&x;", "line 13, column 22: '&x;' is no entity of XML"},
       {attitude_xml, "ORBITER", "A &#10;B", "line 13, column 24: '&#10;' is no entity of XML"},
       {attitude_xml, "ORBITER", "&#xD800;", "line 13, column 22: '&#xD800;' is no entity of XML"},
       {attitude_xml, "ORBITER", "&#x110000;", "line 13, column 22: '&#x110000;' is no entity of XML"},
       {attitude_xml, "ORBITER", "R&D", "line 13, column 23: '&D' is no entity of XML"}},
      "attitude ephemeris message");
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

TEST(XmlMessages, EveryFaultHasALineAColumnAndAReason) {
  expect_faults<AttitudeEphemerisMessage>(
      {{attitude_xml, "version=\"1.0\">", "version=\"4.0\">",
        "line 2, column 2 (CCSDS_AEM_VERS): '4.0': the versions are 1.0, 2.0"},
       {attitude_xml, " version=\"1.0\">", ">",
        "line 2, column 2 (CCSDS_AEM_VERS): '': the versions are 1.0, 2.0"},
       {attitude_xml, "id=\"CCSDS_AEM", "id=\"CCSDS_OEM",
        "line 2, column 2: <aem>: its id is 'CCSDS_OEM_VERS', not CCSDS_AEM_VERS"},
       {attitude_xml, "UTF-8", "ISO-8859-1",
        "line 1, column 3: <xml>: the encoding is 'ISO-8859-1'; UTF-8 is read, and UTF-16 with its mark"},
       {attitude_xml, "</header>", "", "line 62, column 3: it is not well-formed: Start-end tags mismatch"},
       {attitude_xml, "</aem>\n", "</aem>\n<aem/>\n",
        "line 63, column 2: <aem>: a second element outside of the first"},
       {attitude_xml, "</aem>\n", "</aem>\nmore\n", "line 63, column 4: text behind the document"},
       {attitude_xml, "<body>", "<trunk/><body>", "line 8, column 4: <trunk>: expected header or body"},
       {attitude_xml, "<body>", "<body>text", "line 8, column 9: text between elements"},
       {attitude_xml, "<metadata>", "<metdata></metdata><metadata>",
        "line 9, column 6: <segment>: expected metadata in it"},
       {attitude_xml, "<OBJECT_ID/>", "<OBJECT_ID/><OBJECT_NAME>X</OBJECT_NAME>",
        "line 14, column 34 (OBJECT_NAME): 'X': the keyword is there for the second time, after line 13"},
       {attitude_xml, "<OBJECT_ID/>", "", "the segment from line 9 on: there is no OBJECT_ID"},
       {attitude_xml, "<OBJECT_ID/>", "<OBJECT_ID><X/></OBJECT_ID>",
        "line 14, column 21: <X>: an element within a value"},
       {attitude_xml, "<OBJECT_ID/>", "<objectId/>",
        "line 14, column 10: <objectId>: 'objectId' is no keyword"},
       {attitude_xml, "ORBITER", "OR\nBITER",
        "line 13, column 10: <OBJECT_NAME>: its value is of several lines"},
       {attitude_xml, "ORBITER", "\xC3\x84",
        "line 13, column 22: the byte 195 is no printable character of ASCII"},
       {attitude_xml, ">TAI", ">GMST",
        "line 18, column 22 (TIME_SYSTEM): 'GMST': the time systems that are read are UTC, TAI, TT, TDB and "
        "GPS"},
       {attitude_xml, "<STOP_TIME>2021-04-15T13:31:23.0", "<STOP_TIME>2021-04-15T13:31:19",
        "line 20, column 20 (STOP_TIME): '2021-04-15T13:31:19': it is before START_TIME, "
        "2021-04-15T13:31:20.000"},
       {attitude_xml, "<MISSION_PHASE>cruise</MISSION_PHASE>", "<STOP_TIM>cruise</STOP_TIM>",
        "line 23, column 19 (STOP_TIM): 'cruise': the keyword is not of the standard, but nearly STOP_TIME"},
       {attitude_xml, ">0.6<", ">x<", "line 29, column 27 (Q1): 'x': not a finite number"},
       {attitude_xml, ">0.6<", ">0.6 0<", "line 29, column 27: '0.6 0': more than one number"},
       {attitude_xml, ">0.6<", "><", "line 29, column 24: <Q1>: it is empty"},
       {attitude_xml, "<Q1>0.6</Q1>", "", "line 27, column 10: <attitudeState>: there is no Q1"},
       {attitude_xml, "<Q1>0.6</Q1>", "<Q1>0.6</Q1><Q1>0.6</Q1>",
        "line 29, column 36: <Q1>: 'Q1' is not of this line of data, or twice"},
       {attitude_xml, "<Q1>0.6", "<Q1 units=\"deg\">0.6",
        "line 29, column 24: <Q1>: the unit is 'deg'; it has no unit"},
       {attitude_xml, "units=\"deg\">20", "unit=\"rad\">20",
        "line 55, column 14: <rotation2>: the attribute 'unit'; a value may have units, parameter, angle or "
        "rate"},
       {attitude_xml, "units=\"deg\">20", "units=\"deg\" units=\"rad\">20",
        "line 55, column 14: <rotation2>: the attribute 'units' is there twice"},
       {attitude_xml, "units=\"deg\">20", "units=\"rad\">20",
        "line 55, column 14: <rotation2>: the unit is 'rad', not 'deg'"},
       {attitude_xml, "\"X_ANGLE\"", "\"Y_ANGLE\"",
        "line 51, column 10: <attitudeState>: there is no X_ANGLE"},
       {attitude_xml, ">0.6<", ">0.7<",
        "line 29, column 60 (QC): '+8e-001': of a quaternion whose norm is 1.0630145812734648; it may differ "
        "from 1 "
        "by 0.01"},
       {attitude_xml, "2021-105T13:31:21", "2021-105T13:31:19",
        "line 32, column 18 (EPOCH): '2021-105T13:31:19': not later than the line before, at "
        "2021-04-15T13:31:20.000"},
       {attitude_xml, "<attitudeState>", "<attitude/><attitudeState>",
        "line 27, column 10: <attitude>: expected attitudeState"},
       {attitude_xml, "<quaternion>", "<quaternion><a><b><c><d/></c></b></a>",
        "line 29, column 27: <b>: elements within so many others are not of a message"}},
      "attitude ephemeris message");
  expect_faults<OrbitEphemerisMessage>(
      {{orbit_xml, "units=\"km\"", "units=\"ft\"", "line 12, column 2: <X>: the unit is 'ft', not 'km'"},
       {orbit_xml, "units=\"km/s\"", "units=\"m\xC3\x97s\xE2\x81\xBB\xC2\xB9\"",
        "line 13, column 2: <X_DOT>: the attribute 'units' is not one line of printable ASCII"},
       {orbit_xml, "<Y_DDOT>8</Y_DDOT>", "", "line 14, column 2: <stateVector>: there is no Y_DDOT"},
       {orbit_xml, "<CY_Y>", "<CY_Y units=\"km\">",
        "line 19, column 2: <CY_Y>: the unit is 'km', not 'km**2'"},
       {orbit_xml, "<CX_X>1</CX_X>", "", "line 16, column 2: <covarianceMatrix>: there is no CX_X"},
       {orbit_xml, "<CX_X>", "<CX_X>1</CX_X><CX_X>", "line 17, column 2: <CX_X>: it is there twice"},
       {orbit_xml, "<CX_X>", "<CX_Z>1</CX_Z><CX_X>", "line 17, column 2: <CX_Z>: it is not of a covariance"},
       {orbit_xml, "<CX_X>1<", "<CX_X>-1<",
        "line 17, column 7 (covariance): '-1': a variance that is negative"}},
      "orbit ephemeris message");
  expect_faults<OrbitParameterMessage>(
      {{orbit_parameters_xml, "units=\"m**2\"", "units=\"s\"",
        "line 8, column 72 (DRAG_AREA): '10 [s]': the unit is [m**2]"},
       {orbit_parameters_xml, "parameter=\"EARTH_MODEL\"", "parameter=\"earth model\"",
        "line 13, column 25: <USER_DEFINED>: 'USER_DEFINED_earth model' is no keyword"},
       {orbit_parameters_xml, "<stateVector>", "<stateVector><x><y/></x>",
        "line 6, column 21: <x>: 'x' is no keyword"}},
      "orbit parameter message");
}

const std::string oldest_rates_kvn =
    replaced(replaced(replaced(replaced(rates_kvn, "VERS = 2.0", "VERS = 1.0"), "/ANGVEL", "/RATE"),
                      "ANGVEL_FRAME", "RATE_FRAME"),
             "TIME_SYSTEM", "ATTITUDE_DIR = A2B\nQUATERNION_TYPE = LAST\nTIME_SYSTEM");

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
  for (const std::string& text : {attitude_kvn, rates_kvn, oldest_rates_kvn, derivative, oldest_derivative,
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
      AttitudeEphemerisMessage::parse(replaced(oldest_rates_kvn, "ORIGINATOR =", "ORIGINATOR = A & B <C>"))
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
