#pragma once

#include <numbers>
#include <string>

#include <vectrix/space.hpp>

namespace vectrix::attitude_parameter_message_test {

using earth::Eme2000, earth::Itrf;
using Message = AttitudeParameterMessage;

struct Body : moving_frame {};
struct Instrument : moving_frame {};

inline constexpr double degree = std::numbers::pi / 180.0;

// Of CS-SI/Orekit (at fe4aee84, Apache-2.0): the quaternion and the Euler angles are not the same attitude.
inline const std::string two_forms = R"(CCSDS_APM_VERS  = 1.0
CREATION_DATE   = 2004-02-14T19:23:57
ORIGINATOR      = JPL

OBJECT_NAME     = MARS SPIRIT
OBJECT_ID       = 2004-003A
CENTER_NAME     = EARTH
TIME_SYSTEM     = UTC
COMMENT           GEOCENTRIC, CARTESIAN, EARTH FIXED
EPOCH           = 2004-02-14T14:28:15.1172
Q_FRAME_A       = INSTRUMENT_A
Q_FRAME_B       = ITRF-97
Q_DIR           = A2B

Q1              = 0.03123
Q2              = 0.78543
Q3              = 0.39158
QC              = 0.47832

COMMENT           Attitude specified as Euler elements
EULER_FRAME_A   = ITRF-97
EULER_FRAME_B   = INSTRUMENT_A
EULER_DIR       = A2B
EULER_ROT_SEQ   = 312
RATE_FRAME      = EULER_FRAME_A
Z_ANGLE         = -53.3688
X_ANGLE         = 139.7527
Y_ANGLE         = 25.0658
Z_RATE          = 0.02156
X_RATE          = 0.1045
Y_RATE          = 0.03214

COMMENT           Spacecraft Parameters
I11               = 6080.0
I22               = 5245.5
I33               = 8067.3
I12               = -135.9
I13               = 89.3
I23               = -90.7

COMMENT           Data follows for 1 planned maneuver.
MAN_EPOCH_START = 2004-02-14T14:29:00.5098
MAN_DURATION    = 3
MAN_REF_FRAME   = INSTRUMENT_A
MAN_TOR_1       = -1.25
MAN_TOR_2       = -0.5
MAN_TOR_3       = 0.5
)";

// Version 2.0, written here: every block, some of them twice, and what the version has in addition.
inline const std::string blocks = R"(CCSDS_APM_VERS = 2.0
COMMENT of the header
CLASSIFICATION = public
CREATION_DATE = 2026-01-02T03:04:05
ORIGINATOR = HERE
MESSAGE_ID = 7
MISSION_PHASE = cruise, 2

COMMENT of the metadata
OBJECT_NAME = ORBITER
OBJECT_ID = 1996-062A
TIME_SYSTEM = TAI
ZEROTH = = [m]

COMMENT of the epoch
EPOCH = 2026-01-02T00:00:00.25

QUAT_START
COMMENT of the quaternion
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
Q1 = 0.0
Q2 = 0
Q3 = .6
QC = +8e-001
Q1_DOT = 1e-5 [1/s]
Q2_DOT = 0
Q3_DOT = 0
QC_DOT = 0
QUAT_STOP

QUAT_START
REF_FRAME_A = EME2000
REF_FRAME_B = STARTRACKER_2
Q1 = 1
Q2 = 0
Q3 = 0
QC = 0
QUAT_STOP

EULER_START
REF_FRAME_A = SC_BODY_1
REF_FRAME_B = EME2000
EULER_ROT_SEQ = ZXZ
ANGLE_1 = 10 [deg]
ANGLE_2 = 20
ANGLE_3 = 30
ANGLE_1_DOT = 0 [deg/s]
EULER_STOP

ANGVEL_START
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ANGVEL_FRAME = SC_BODY_1
ANGVEL_X = 1 [deg/s]
ANGVEL_Y = -2
ANGVEL_Z = 3
ANGVEL_STOP

SPIN_START
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
SPIN_ALPHA = 1 [deg]
SPIN_DELTA = 2
SPIN_ANGLE = 3
SPIN_ANGLE_VEL = 4 [deg/s]
MOMENTUM_ALPHA = 5
MOMENTUM_DELTA = 6
NUTATION_VEL = 7 [deg/s]
SPIN_STOP

INERTIA_START
INERTIA_REF_FRAME = SC_BODY_1
IXX = 6080.0 [kg*m**2]
IYY = 5245.5
IZZ = 8067.3
IXY = -135.9
IXZ = 89.3
IYZ = -90.7
INERTIA_STOP

MAN_START
MAN_EPOCH_START = 2026-002T00:00:01
MAN_DURATION = 3 [s]
MAN_REF_FRAME = SC_BODY_1
MAN_TOR_X = -1.25 [N*m]
MAN_TOR_Y = -0.5
MAN_TOR_Z = 0.5
MAN_DELTA_MASS = -1 [kg]
USER_DEFINED_VALVE = 3
COMMENT at the end
MAN_STOP
)";

}  // namespace vectrix::attitude_parameter_message_test
