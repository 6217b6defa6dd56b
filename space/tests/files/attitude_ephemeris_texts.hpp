#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix::attitude_ephemeris_message_test {

struct Body : moving_frame {};
struct Tracker : moving_frame {};
struct Ground : moving_frame {};
struct Other : moving_frame {};

// The first lines of two files of nasa/GMAT (at fba14dc4, Apache-2.0): one attitude twice. The file says
// 'Linear' and degree 7.
inline const std::string gmat_quaternions = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2013-11-27T17:22:31
ORIGINATOR = NASA/GSFC

META_START
COMMENT This file was created by SPH as the basic quaternion test file for GMAT
OBJECT_NAME = DefaultSC
OBJECT_ID = NoId
CENTER_NAME = Earth
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ATTITUDE_DIR = A2B
TIME_SYSTEM = UTC
START_TIME         = 2000-01-01T11:59:28.000
USEABLE_START_TIME = 2000-01-01T11:59:28.000
USEABLE_STOP_TIME  = 2000-01-01T12:59:27.061
STOP_TIME          = 2000-01-01T12:59:27.061
ATTITUDE_TYPE = QUATERNION
QUATERNION_TYPE = LAST
INTERPOLATION_METHOD = Linear
INTERPOLATION_DEGREE = 7
META_STOP

DATA_START
2000-01-01T11:59:28.000 0.1952861484651402  -0.07946016321668915  0.3188764252036319  0.9240493645517975
2000-01-01T12:00:28.000 0.1952798100984653  -0.07947577925152362  0.3189502132618343  0.9240238945722674
2000-01-01T12:02:02.637 0.1952698101880961  -0.07950040907203394  0.3190665935366565  0.9239837093127769
DATA_STOP
)";

inline const std::string gmat_angles = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2013-11-27T17:22:31
ORIGINATOR = NASA/GSFC

META_START
OBJECT_NAME = DefaultSC
OBJECT_ID = NoId
CENTER_NAME = Earth
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ATTITUDE_DIR = A2B
TIME_SYSTEM = UTC
START_TIME         = 2000-01-01T11:59:28.000
STOP_TIME          = 2000-01-01T13:49:48.936
ATTITUDE_TYPE      = EULER_ANGLE
EULER_ROT_SEQ = 321
INTERPOLATION_METHOD = LAGRANGE
INTERPOLATION_DEGREE = 7
META_STOP

DATA_START
2000-01-01T11:59:28.000 35.4540963916258  -15.74726604135554  18.80387738364443
2000-01-01T12:00:28.000 35.46309617756187  -15.75021802736601  18.80143473620356
2000-01-01T12:02:02.637 35.47729188926041  -15.75487338383642  18.79758094651204
DATA_STOP
)";

// Of CS-SI/Orekit (at fe4aee84, Apache-2.0): A is the sensor, five digits, and a line 0.5 ms before
// START_TIME.
inline const std::string tracker = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2002-11-04T17:22:31
ORIGINATOR = NASA/JPL

META_START
OBJECT_NAME          = OREKIT_SAT
OBJECT_ID            = 2020-012A
CENTER_NAME          = EARTH
REF_FRAME_A          = STARTRACKER_2
REF_FRAME_B          = GTOD
ATTITUDE_DIR         = B2A
TIME_SYSTEM          = UTC
START_TIME           = 1996-11-28T21:29:07.2555
USEABLE_START_TIME   = 1996-11-28T22:08:02.5555
USEABLE_STOP_TIME    = 1996-11-30T01:18:02.5555
STOP_TIME            = 1996-11-30T01:28:02.5555
ATTITUDE_TYPE        = QUATERNION
QUATERNION_TYPE      = LAST
INTERPOLATION_METHOD = LINEAR
INTERPOLATION_DEGREE = 1
META_STOP

DATA_START
1996-11-28T21:29:07.255 0.56748   0.03146   0.45689   0.68427
1996-11-28T22:08:03.555 0.42319   -0.45697  0.23784   0.74533
1996-11-28T22:08:05.555 -0.84532  0.26974   -0.06532  0.45652
1996-11-30T01:28:02.555  0.74563   -0.45375   0.36875   0.31964
DATA_STOP
)";

// Of the same place: the type is not read, but the dates of this file, with Z, are in the tests below.
inline const std::string spin = R"(CCSDS_AEM_VERS = 1.0
CREATION_DATE      = 2008-071T17:09:49
ORIGINATOR         = GSFC FDF

META_START
OBJECT_NAME        = ST5-224
OBJECT_ID          = 2006224
CENTER_NAME        = EARTH
REF_FRAME_A        = J2000
REF_FRAME_B        = SC_BODY_1
ATTITUDE_DIR       = A2B
TIME_SYSTEM        = UTC
START_TIME         = 2006-090T05:00:00.071
USEABLE_START_TIME = 2006-090T05:00:00.071
USEABLE_STOP_TIME  = 2006-090T05:00:00.946
STOP_TIME          = 2006-090T05:00:00.946
ATTITUDE_TYPE      = SPIN/NUTATION
META_STOP

DATA_START
COMMENT              Spin KF ground solution, SPINKF rates 
2006-090T05:00:00.071Z 268.62512 68.407179 159.5566582 -109.9677896  0.366382445 18.16999799 -156.19211
DATA_STOP
)";

// Version 2.0, written here.
inline const std::string rates = R"(CCSDS_AEM_VERS = 2.0
CLASSIFICATION = public
CREATION_DATE =
ORIGINATOR =
MESSAGE_ID = 8

META_START
COMMENT first
OBJECT_NAME =
OBJECT_ID =
REF_FRAME_A = LVLH
REF_FRAME_B = IMU_FRAME_1
TIME_SYSTEM = TAI
START_TIME = 2021-04-15T13:31:20.0
STOP_TIME = 2021-04-15T13:31:23.0
ATTITUDE_TYPE = QUATERNION/ANGVEL
ANGVEL_FRAME = REF_FRAME_B
INTERPOLATION_DEGREE = 1
META_STOP
COMMENT before the data
DATA_START
2021-04-15T13:31:20.000000000001 .6 0 0 +8e-001 1 -2.5 .3E1
COMMENT between
2021-105T13:31:21 0 0.6 0 0.8 1 -2 3
DATA_STOP
COMMENT between segments

META_START
OBJECT_NAME = A
OBJECT_ID = B
REF_FRAME_A = GCRF
REF_FRAME_B = X
TIME_SYSTEM = TAI
START_TIME = 2021-04-15T13:31:20.0
STOP_TIME = 2021-04-15T13:31:23.0
ATTITUDE_TYPE = EULER_ANGLE
EULER_ROT_SEQ = ZXZ
META_STOP

DATA_START
2021-04-15T13:31:22 90 -450 1e-300
DATA_STOP
COMMENT at the end
)";

using Message = AttitudeEphemerisMessage;
using Segment = AttitudeEphemerisSegment;
using earth::Eme2000, earth::Gcrf;

inline constexpr double degree = std::numbers::pi / 180.0;

inline std::string complaint_of(const std::string& text) {
  return complaint([&] { Message::parse(text); });
}
inline Segment segment_of(const std::string& text) {
  return Message::parse(text).segments().front();
}
template <class A, class B> double angle_between(const Quaternion<A, B>& p, const Quaternion<A, B>& q) {
  return p.eigen().angularDistance(q.eigen());
}
inline const auto body = called<Body>("SC_BODY_1");

}  // namespace vectrix::attitude_ephemeris_message_test
