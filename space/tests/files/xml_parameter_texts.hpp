#pragma once

#include <string>

// Messages of one epoch that are written twice, in XML and in keywords and values, and mean elements in XML.
namespace vectrix::xml_messages_test {

inline const std::string orbit_parameters_xml = R"(<opm id="CCSDS_OPM_VERS" version="3.0">
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
inline const std::string orbit_parameters_kvn = R"(CCSDS_OPM_VERS = 3.0
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
inline const std::string attitude_parameters_xml = R"(<apm id="CCSDS_APM_VERS" version="1.0">
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
inline const std::string attitude_parameters_kvn = R"(CCSDS_APM_VERS = 1.0
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
inline const std::string newer_parameters_xml = R"(<apm id="CCSDS_APM_VERS" version="2.0">
<header><CREATION_DATE>2023-02-03T12:00:00</CREATION_DATE><ORIGINATOR>HERE</ORIGINATOR></header>
<body><segment><metadata><OBJECT_NAME>A</OBJECT_NAME><OBJECT_ID>B</OBJECT_ID><TIME_SYSTEM>TAI</TIME_SYSTEM></metadata>
<data><EPOCH>2023-01-01T00:00:00</EPOCH>
<quaternionState><REF_FRAME_A>EME2000</REF_FRAME_A><REF_FRAME_B>SC_BODY_1</REF_FRAME_B>
<quaternion><Q1>0</Q1><Q2>0</Q2><Q3>0</Q3><QC>1</QC></quaternion></quaternionState>
<angularVelocity><REF_FRAME_A>EME2000</REF_FRAME_A><REF_FRAME_B>SC_BODY_1</REF_FRAME_B>
<ANGVEL_FRAME>SC_BODY_1</ANGVEL_FRAME><ANGVEL_X units="deg/s">1</ANGVEL_X><ANGVEL_Y>2</ANGVEL_Y>
<ANGVEL_Z>3</ANGVEL_Z></angularVelocity></data></segment></body></apm>)";
inline const std::string newer_parameters_kvn = R"(CCSDS_APM_VERS = 2.0
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
inline const std::string elements_xml = R"(<omm id="CCSDS_OMM_VERS" version="3.0">
<header><CREATION_DATE/><ORIGINATOR/></header><body><segment><metadata><OBJECT_NAME>ISS (ZARYA)</OBJECT_NAME>
<OBJECT_ID>1998-067A</OBJECT_ID><CENTER_NAME>EARTH</CENTER_NAME><REF_FRAME>TEME</REF_FRAME>
<TIME_SYSTEM>UTC</TIME_SYSTEM><MEAN_ELEMENT_THEORY>SGP4</MEAN_ELEMENT_THEORY></metadata><data>
<meanElements><EPOCH>2026-07-21T04:27:10.178208</EPOCH><MEAN_MOTION units="rev/day">15.49071756</MEAN_MOTION>
<ECCENTRICITY>.00068493</ECCENTRICITY><INCLINATION>51.6316</INCLINATION><RA_OF_ASC_NODE>131.8443</RA_OF_ASC_NODE>
<ARG_OF_PERICENTER>320.6461</ARG_OF_PERICENTER><MEAN_ANOMALY>39.4029</MEAN_ANOMALY></meanElements>
<tleParameters><NORAD_CAT_ID>25544</NORAD_CAT_ID><BSTAR>.11479289E-3</BSTAR></tleParameters>
</data></segment></body></omm>)";

}  // namespace vectrix::xml_messages_test
