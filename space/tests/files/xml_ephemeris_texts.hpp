#pragma once

#include <string>

// Ephemerides that are written twice, in XML and in keywords and values: they are the same messages.
namespace vectrix::xml_messages_test {

inline const std::string attitude_xml = R"(<?xml version="1.0" encoding="UTF-8"?>
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
inline const std::string attitude_kvn = R"(CCSDS_AEM_VERS = 1.0
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

inline const std::string rates_xml =
    R"(<aem version="2.0"><header><CREATION_DATE/><ORIGINATOR/></header><body><segment>
<metadata><OBJECT_NAME>A</OBJECT_NAME><OBJECT_ID>B</OBJECT_ID><REF_FRAME_A>GCRF</REF_FRAME_A>
<REF_FRAME_B>BODY</REF_FRAME_B><TIME_SYSTEM>UTC</TIME_SYSTEM><START_TIME>2021-04-15T13:31:20</START_TIME>
<STOP_TIME>2021-04-15T13:31:20</STOP_TIME><ATTITUDE_TYPE>QUATERNION/ANGVEL</ATTITUDE_TYPE>
<ANGVEL_FRAME>REF_FRAME_B</ANGVEL_FRAME></metadata>
<data><attitudeState><quaternionAngVel><EPOCH>2021-04-15T13:31:20</EPOCH>
<quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion>
<angVel><ANGVEL_X units="deg/s">1</ANGVEL_X><ANGVEL_Y>2</ANGVEL_Y><ANGVEL_Z>3</ANGVEL_Z></angVel>
</quaternionAngVel></attitudeState></data></segment></body></aem>)";
inline const std::string rates_kvn = R"(CCSDS_AEM_VERS = 2.0
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
inline std::string covariance_xml() {
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

inline const std::string orbit_xml = R"(<?xml version="1.0"?>
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
inline const std::string orbit_kvn = R"(CCSDS_OEM_VERS = 3.0
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

}  // namespace vectrix::xml_messages_test
