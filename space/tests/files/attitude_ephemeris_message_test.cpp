#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "temporary_file.hpp"

namespace vectrix::attitude_ephemeris_message_test {

struct Body : moving_frame {};
struct Tracker : moving_frame {};
struct Ground : moving_frame {};
struct Other : moving_frame {};

namespace {

using Message = AttitudeEphemerisMessage;
using Segment = AttitudeEphemerisSegment;
using earth::Eme2000, earth::Gcrf;

constexpr double degree = std::numbers::pi / 180.0;

// The first lines of two files of nasa/GMAT (at fba14dc4, Apache-2.0): one attitude twice. The file says
// 'Linear' and degree 7.
const std::string gmat_quaternions = R"(CCSDS_AEM_VERS = 1.0
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
const std::string gmat_angles = R"(CCSDS_AEM_VERS = 1.0
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
const std::string tracker = R"(CCSDS_AEM_VERS = 1.0
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
const std::string spin = R"(CCSDS_AEM_VERS = 1.0
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
const std::string rates = R"(CCSDS_AEM_VERS = 2.0
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

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const auto at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}
std::string complaint_of(const std::string& text) {
  return complaint([&] { Message::parse(text); });
}
Segment segment_of(const std::string& text) {
  return Message::parse(text).segments().front();
}
template <class A, class B> double angle_between(const Quaternion<A, B>& p, const Quaternion<A, B>& q) {
  return p.eigen().angularDistance(q.eigen());
}
const auto body = called<Body>("SC_BODY_1");

// Made of the definition of the standard, in elementary turns of the axes, without quaternions.
Eigen::Matrix3d turned_axes(int axis, double degrees) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m(j, j) = m(k, k) = std::cos(degrees * degree);
  m(j, k) = std::sin(degrees * degree);
  m(k, j) = -m(j, k);
  return m;
}

TEST(AttitudeEphemerisMessage, QuaternionsAndAnglesOfGmatAreOneAttitude) {
  const auto quaternions = segment_of(gmat_quaternions).samples<Eme2000, Body>(body);
  const auto angles = segment_of(gmat_angles).samples<Eme2000, Body>(body);
  ASSERT_EQ(quaternions.size(), 3U);
  ASSERT_EQ(angles.size(), 3U);
  constexpr double digits = 1e-15;  // of the written angles, 16 digits of up to 36 deg: 1e-14 deg
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(quaternions[i].time, angles[i].time);
    EXPECT_LT(angle_between(quaternions[i].q_a_from_b, angles[i].q_a_from_b), 10 * digits);
  }
  // Coordinates go from A to B by the matrix R1(c) R2(b) R3(a) of the standard.
  const Eigen::Matrix3d standard = turned_axes(0, 18.80387738364443) * turned_axes(1, -15.74726604135554) *
                                   turned_axes(2, 35.4540963916258);
  EXPECT_LT((inverse(dcm(quaternions[0].q_a_from_b)).matrix() - standard).norm(), 10 * digits);
  EXPECT_EQ(quaternions[2].time, Epoch::from_utc("2000-01-01T12:02:02.637"));
  EXPECT_EQ(quaternions[0].q_a_from_b.eigen().w(), 0.9240493645517975);
}

TEST(AttitudeEphemerisMessage, EverySequenceIsThatOfTheStandard) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-400.0, 400.0);
  for (const std::string sequence :
       {"123", "132", "213", "231", "312", "321", "121", "131", "212", "232", "313", "323"}) {
    const double t[] = {any(random), any(random), any(random)};
    const std::string line =
        "2000-01-01T11:59:28 " + detail::text(t[0]) + " " + detail::text(t[1]) + " " + detail::text(t[2]);
    std::string letters = sequence;
    for (char& c : letters) c = static_cast<char>(c - '1' + 'X');
    const Eigen::Matrix3d standard = turned_axes(sequence[2] - '1', t[2]) *
                                     turned_axes(sequence[1] - '1', t[1]) *
                                     turned_axes(sequence[0] - '1', t[0]);
    for (const std::string& written : {sequence, letters}) {
      const std::string text =
          replaced(replaced(gmat_angles, "321", written),
                   "2000-01-01T11:59:28.000 35.4540963916258  -15.74726604135554  18.80387738364443", line);
      const auto q = segment_of(text).samples<Eme2000, Body>(body).front().q_a_from_b;
      EXPECT_LT((inverse(dcm(q)).matrix() - standard).norm(), 1e-14) << written;
    }
  }
}

TEST(AttitudeEphemerisMessage, DirectionAndOrderOfTheScalarAreThoseOfTheFile) {
  const auto a2b = segment_of(gmat_quaternions).samples<Eme2000, Body>(body);
  const auto b2a = segment_of(replaced(gmat_quaternions, "A2B", "b2a")).samples<Eme2000, Body>(body);
  EXPECT_EQ(b2a[1].q_a_from_b.eigen().coeffs(), a2b[1].q_a_from_b.eigen().conjugate().coeffs());
  // Asked for the other way round, and with the frames exchanged in the file.
  const auto reversed = segment_of(gmat_quaternions).samples<Body, Eme2000>(body);
  EXPECT_EQ(reversed[1].q_a_from_b.eigen().coeffs(), inverse(a2b[1].q_a_from_b).eigen().coeffs());
  const std::string exchanged =
      replaced(replaced(gmat_quaternions, "REF_FRAME_A = EME2000", "REF_FRAME_A = SC_BODY_1"),
               "REF_FRAME_B = SC_BODY_1", "REF_FRAME_B = EME2000");
  EXPECT_EQ((segment_of(exchanged).samples<Body, Eme2000>(body)[1].q_a_from_b.eigen().coeffs()),
            a2b[1].q_a_from_b.eigen().coeffs());
  const auto first = segment_of(replaced(gmat_quaternions, "= LAST", "= First")).samples<Eme2000, Body>(body);
  EXPECT_EQ(first[0].q_a_from_b.scalar_first(),
            (std::array{0.1952861484651402, -0.07946016321668915, 0.3188764252036319, 0.9240493645517975}));
}

TEST(AttitudeEphemerisMessage, OfASensor) {
  const Segment segment = segment_of(tracker);
  EXPECT_EQ(segment.ref_frame_a(), "STARTRACKER_2");
  const auto sensor = called<Tracker>("startracker_2");
  const auto ground = called<Ground>("GTOD");
  // B2A: the quaternion of the file gives coordinates in B of those in A.
  const auto [samples, distance] = segment.nearest_samples<Ground, Tracker>(sensor, ground);
  ASSERT_EQ(samples.size(), 4U);
  const Eigen::Quaterniond written(0.68427, 0.56748, 0.03146, 0.45689);
  EXPECT_LT((samples[0].q_a_from_b.eigen().coeffs() - written.normalized().coeffs()).norm(), 1e-16);
  constexpr double half_a_digit = 0.5e-5;  // of each of four numbers, of which the sum is 2 at most
  EXPECT_LT(distance, 2 * half_a_digit);
  EXPECT_GT(distance, 1e-7);
  EXPECT_EQ((segment.nearest_samples<Tracker, Ground>(ground, sensor).samples[0].q_a_from_b.eigen().coeffs()),
            samples[0].q_a_from_b.eigen().conjugate().coeffs());
  const std::string refused = complaint([&] { return segment.samples<Ground, Tracker>(sensor, ground); });
  EXPECT_TRUE(refused.starts_with("attitude ephemeris message, the segment from line 5 on, line 2"))
      << refused;
  EXPECT_NE(refused.find(": the norm of the quaternion differs from 1 by "), std::string::npos);
  EXPECT_TRUE(refused.ends_with("tolerance 1.25e-10; nearest_samples() projects"));
}

TEST(AttitudeEphemerisMessage, OtherFramesAreRefused) {
  const Segment segment = segment_of(gmat_quaternions);
  const std::string place = "attitude ephemeris message, the segment from line 5 on: ";
  EXPECT_EQ(complaint([&] { return segment.samples<Gcrf, Body>(body); }),
            place +
                "REF_FRAME_A is 'EME2000', REF_FRAME_B is 'SC_BODY_1'; asked for 'SC_BODY_1' "
                "(attitude_ephemeris_message_test::Body) relative to 'GCRF' (earth::Gcrf)");
  EXPECT_EQ(complaint([&] { return segment.nearest_samples<Eme2000, Other>(called<Other>("SC_BODY_2")); }),
            place +
                "REF_FRAME_A is 'EME2000', REF_FRAME_B is 'SC_BODY_1'; asked for 'SC_BODY_2' "
                "(attitude_ephemeris_message_test::Other) relative to 'EME2000' (earth::Eme2000)");
  EXPECT_EQ(complaint([&] { return segment.samples<Gcrf, Body>(body, called<Gcrf>("EME2000")); }),
            place + "REF_FRAME_A is 'EME2000', earth::Eme2000; it was claimed to be earth::Gcrf");
  EXPECT_EQ(complaint([&] { return segment.angular_velocities<Eme2000, Body>(in<Body>, body); }),
            place + "the attitude type has no rates");
  EXPECT_NO_THROW((segment.samples<Other, Body>(body, called<Other>("EME2000"))));
}

TEST(AttitudeEphemerisMessage, RatesOfTheFile) {
  const auto message = Message::parse(rates);
  ASSERT_EQ(message.segments().size(), 2U);
  const Segment& segment = message.segments()[0];
  EXPECT_EQ(segment.type(), AttitudeType::quaternion_rate);
  EXPECT_EQ(segment.metadata().comments, std::vector<std::string>{"first"});
  EXPECT_EQ(segment.comments(), (std::vector<std::string>{"before the data", "between"}));
  EXPECT_EQ(message.segments()[1].metadata().comments, std::vector<std::string>{"between segments"});
  EXPECT_EQ(message.segments()[1].comments(), std::vector<std::string>{"at the end"});
  const auto lvlh = called<Other>("LVLH");
  const auto imu = called<Body>("IMU_FRAME_1");
  const auto samples = segment.samples<Other, Body>(lvlh, imu);
  EXPECT_EQ(samples[0].time, Epoch::from(scale::tai, "2021-04-15T13:31:20.000000000001"));
  EXPECT_EQ(samples[0].q_a_from_b.scalar_last(), (std::array{0.6, 0.0, 0.0, 0.8}));
  const auto w = segment.angular_velocities<Other, Body>(in<Body>, lvlh, imu);
  static_assert(std::is_same_v<decltype(w), const std::vector<AngularVelocity<Other, Body, In<Body>>>>);
  const Eigen::Vector3d written = degree * Eigen::Vector3d(1, -2.5, 3);
  EXPECT_LT((w[0].coordinates() - written).norm(), 1e-17);
  const auto opposite = segment.angular_velocities<Body, Other>(in<Body>, lvlh, imu);
  EXPECT_LT((opposite[0].coordinates() + written).norm(), 1e-17);
  EXPECT_EQ(complaint([&] { return segment.angular_velocities<Other, Body>(in<Other>, lvlh, imu); }),
            "attitude ephemeris message, the segment from line 7 on: the rates are in REF_FRAME_B, "
            "'IMU_FRAME_1'; asked for 'LVLH' (attitude_ephemeris_message_test::Other)");
  const Segment in_a = segment_of(replaced(rates, "= REF_FRAME_B", "= lvlh"));
  EXPECT_NO_THROW((in_a.angular_velocities<Other, Body>(in<Other>, lvlh, imu)));
  EXPECT_NO_THROW((in_a.angular_velocities<Body, Other>(in<Other>, lvlh, imu)));
  EXPECT_THROW((in_a.angular_velocities<Other, Body>(in<Body>, lvlh, imu)), BadInput);

  std::string old = replaced(gmat_quaternions, "QUATERNION\n", "QUATERNION/RATE\nRATE_FRAME = REF_FRAME_A\n");
  for (const char* end : {"0.9240493645517975", "0.9240238945722674", "0.9239837093127769"})
    old = replaced(old, end, std::string{end} + " 0 0 0.06");
  EXPECT_EQ((segment_of(old).angular_velocities<Eme2000, Body>(in<Eme2000>, body)[2].coordinates().z()),
            0.06 * degree);
  EXPECT_EQ(
      complaint([&] {
        return segment_of(replaced(old, "A2B", "B2A")).angular_velocities<Eme2000, Body>(in<Eme2000>, body);
      }),
      "attitude ephemeris message, the segment from line 5 on: with ATTITUDE_DIR B2A it is not said "
      "whether the rates are of EME2000 or of SC_BODY_1");
}

struct Fault {
  const std::string& text;
  std::string old, by, reason;
};

TEST(AttitudeEphemerisMessage, EveryFaultHasALineAColumnAndAReason) {
  const std::string line =
      "2000-01-01T11:59:28.000 0.1952861484651402  -0.07946016321668915  0.3188764252036319  "
      "0.9240493645517975";
  const auto data = [&](const std::string& by, const std::string& reason) {
    return Fault{gmat_quaternions, line, by, "line 25, column " + reason};
  };
  const Fault faults[] = {
      {gmat_quaternions, "1.0", "3.0",
       "line 1, column 18 (CCSDS_AEM_VERS): '3.0': the versions are 1.0, 2.0"},
      {gmat_quaternions, "CCSDS_AEM", "CCSDS_OEM",
       "line 1, column 18 (CCSDS_OEM_VERS): '1.0': a message begins with CCSDS_AEM_VERS"},
      {gmat_quaternions, "CCSDS_AEM_VERS = 1.0", "<!DOCTYPE a SYSTEM \"file:///etc/passwd\">",
       "line 1, column 1: '<!DOCTYPE a SYSTEM \"file:///etc/passwd\">': XML is not supported, only keyword = "
       "value"},
      {gmat_quaternions, "CCSDS", "\xFF\xFE",
       "line 1, column 1: the byte 255 is no printable character of ASCII"},
      {gmat_quaternions, "CREATION", "MESSAGE_ID = 1\nCREATION",
       "line 2, column 14 (MESSAGE_ID): '1': the keyword is of version 2.0"},
      {gmat_quaternions, "OBJECT_ID = NoId", "OBJECT_NAME = NoId",
       "line 8, column 15 (OBJECT_NAME): 'NoId': the keyword is there for the second time, after line 7"},
      {gmat_quaternions, "OBJECT_ID = NoId", "", ", the segment from line 5 on: there is no OBJECT_ID"},
      {gmat_quaternions, "OBJECT_ID = NoId", "REF_FRAME = NoId",
       "line 8, column 13 (REF_FRAME): 'NoId': the keyword is not of the metadata"},
      {gmat_quaternions, "REF_FRAME_A = EME2000", "",
       ", the segment from line 5 on: there is no REF_FRAME_A"},
      {gmat_quaternions, "REF_FRAME_B = SC_BODY_1",
       "REF_FRAME_B =", "line 11, column 14 (REF_FRAME_B): '': it is empty"},
      {gmat_quaternions, "REF_FRAME_B = SC_BODY_1", "REF_FRAME_B = eme2000",
       "line 11, column 15 (REF_FRAME_B): 'eme2000': it is REF_FRAME_A, too"},
      {gmat_quaternions, "ATTITUDE_DIR = A2B", "", ", the segment from line 5 on: there is no ATTITUDE_DIR"},
      {gmat_quaternions, "A2B", "A2C", "line 12, column 16 (ATTITUDE_DIR): 'A2C': it is A2B or B2A"},
      {gmat_quaternions, "1.0", "2.0",
       "line 12, column 16 (ATTITUDE_DIR): 'A2B': the keyword is of version 1.0, the message of version 2.0"},
      {gmat_quaternions, "UTC", "MRT",
       "line 13, column 15 (TIME_SYSTEM): 'MRT': the time systems that are read are UTC, TAI, TT, TDB and "
       "GPS"},
      {gmat_quaternions, "UTC", "GMST",
       "line 13, column 15 (TIME_SYSTEM): 'GMST': the time systems that are read"},
      {gmat_quaternions, "START_TIME         = 2000-01-01T11:59:28.000", "START_TIME = 2000-01-01T11:59:60",
       "line 14, column 14 (START_TIME): '2000-01-01T11:59:60': epoch '2000-01-01T11:59:60' in UTC: there is "
       "no such second"},
      {gmat_quaternions, "STOP_TIME  = 2000-01-01T12:59:27.061", "STOP_TIME  = 2000-01-01T13:59:27.061",
       "line 17, column 22 (STOP_TIME): '2000-01-01T12:59:27.061': it is before USEABLE_STOP_TIME"},
      {gmat_quaternions, "ATTITUDE_TYPE = QUATERNION", "",
       ", the segment from line 5 on: there is no ATTITUDE_TYPE"},
      {gmat_quaternions, "= QUATERNION", "= DCM",
       "line 18, column 17 (ATTITUDE_TYPE): 'DCM': the attitude types that are read in version 1.0 are "
       "QUATERNION, QUATERNION/RATE, EULER_ANGLE"},
      {gmat_quaternions, "= QUATERNION", "= QUATERNION/ANGVEL",
       "line 18, column 17 (ATTITUDE_TYPE): 'QUATERNION/ANGVEL': the attitude types that are read in version "
       "1.0 are QUATERNION, QUATERNION/RATE, EULER_ANGLE"},
      {gmat_quaternions, "= QUATERNION", "= QUATERNION/RATE",
       ", the segment from line 5 on: there is no RATE_FRAME"},
      {gmat_quaternions, "QUATERNION_TYPE = LAST", "",
       ", the segment from line 5 on: there is no QUATERNION_TYPE"},
      {gmat_quaternions, "= LAST", "= SECOND",
       "line 19, column 19 (QUATERNION_TYPE): 'SECOND': it is FIRST or LAST"},
      {gmat_quaternions, "DEGREE = 7", "DEGREE = -7",
       "line 21, column 24 (INTERPOLATION_DEGREE): '-7': not a whole number"},
      {gmat_quaternions, "DATA_START", "",
       "line 25, column 1: '2000-01-01T11:59:28.000 0.1952861484651402  -0.0794601632166...': expected "
       "DATA_START"},
      {gmat_quaternions, "DATA_STOP\n", "", ", the segment from line 5 on: there is no DATA_STOP"},
      {gmat_quaternions, "DATA_STOP\n", "META_START\n",
       "line 28, column 1: 'META_START': no line of data, and not DATA_STOP"},
      {gmat_quaternions, "DATA_STOP\n", "DATA_STOP\nX\n",
       "line 29, column 1: 'X': expected META_START after DATA_STOP"},
      {gmat_quaternions, "DATA_STOP\n", "USER_DEFINED_TEST_KEY = bad\n",
       "line 28, column 1: 'USER_DEFINED_TEST_KEY = bad': no line of data, and not DATA_STOP"},
      {gmat_quaternions, "DATA_START\n", "DATA_START\nDATA_STOP\n",
       ", the segment from line 5 on: there are no data lines"},
      {gmat_quaternions, "12:00:28.000 0.19", "11:59:28.000 0.19",
       "line 26, column 1 (EPOCH): '2000-01-01T11:59:28.000': not later than the line before"},
      {gmat_quaternions, "2000-01-01T12:02:02.637", "2000-01-01T13:02:02.637",
       "line 27, column 1 (EPOCH): '2000-01-01T13:02:02.637': outside START_TIME and STOP_TIME"},
      data("2000-01-01T11:59:28.000 0.6 0 0",
           "1: '2000-01-01T11:59:28.000 0.6 0 0': 4 fields; a line of QUATERNION has an epoch and 4 numbers"),
      data("2000-01-01T11:59:28.000 0.6 0 0 0.8 1",
           "1: '2000-01-01T11:59:28.000 0.6 0 0 0.8 1': 6 fields; a line of QUATERNION has an epoch and 4 "
           "numbers"),
      data("2000-01-01T11:59:28.000 0.6 0 nan 0.8", "31 (Q3): 'nan': not a finite number"),
      data("2000-01-01T11:59:28.000 0.6 0 0 0.8D0", "33 (QC): '0.8D0': not a finite number"),
      data("2000-01-01T11:59:28.000 0.6 -inf 0 0.8", "29 (Q2): '-inf': not a finite number"),
      data("2000-01-01T11:59:28.000 3735472A^0 0 0 0.8", "25 (Q1): '3735472A^0': not a finite number"),
      data("2000-01-01T11:59:28.000 0.6 0 0 0.6",
           "25 (Q1): '0.6': of a quaternion whose norm is 0.848528137423857"),
      data("2000-01-01T11:59:28.000 780238475 -440122768 1778245863 -188046590",
           "25 (Q1): '780238475': of a quaternion whose norm is 1"),
      data("2000-01-01T11:59:28.000 0 0 0 0", "25 (Q1): '0': of a quaternion whose norm is 0"),
      data("2000-01-01 0.6 0 0 0.8",
           "1 (EPOCH): '2000-01-01': epoch '2000-01-01' in UTC: it is not written as "
           "2022-04-14T10:22:11.874999"),
      {gmat_angles, "EULER_ROT_SEQ = 321", "", ", the segment from line 5 on: there is no EULER_ROT_SEQ"},
      {gmat_angles, "321", "322",
       "line 16, column 17 (EULER_ROT_SEQ): '322': no sequence of three axes such as 321 or ZYX, none twice "
       "in a row"},
      {gmat_angles, "321", "XYA",
       "line 16, column 17 (EULER_ROT_SEQ): 'XYA': no sequence of three axes such as 321 or ZYX, none twice "
       "in a row"},
      {gmat_angles, "18.80387738364443", "1e999",
       "line 22, column 63 (ANGLE_3): '1e999': not a finite number"},
      {rates, "ANGVEL_FRAME = REF_FRAME_B", "", ", the segment from line 7 on: there is no ANGVEL_FRAME"},
      {rates, "ANGVEL_FRAME", "RATE_FRAME",
       "line 17, column 14 (RATE_FRAME): 'REF_FRAME_B': the keyword is of version 1.0, the message of "
       "version 2.0"},
      {rates, "= REF_FRAME_B", "= BODY",
       "line 17, column 16 (ANGVEL_FRAME): 'BODY': it is REF_FRAME_A or REF_FRAME_B"},
      {rates, "REF_FRAME_B = X\nTIME_SYSTEM = TAI", "REF_FRAME_B = X\nTIME_SYSTEM = UTC",
       "line 33, column 15 (TIME_SYSTEM): 'UTC': the first segment has TAI; a message has one time system"},
      {rates, "1 -2.5 .3E1", "1 -2.5 .3E1 4",
       "line 22, column 1: '2021-04-15T13:31:20.000000000001 .6 0 0 +8e-001 1 -2.5 .3E1 ...': 9 fields; a "
       "line of QUATERNION/ANGVEL has an epoch and 7 numbers"},
      {spin, "J2000", "J2000",
       "line 17, column 22 (ATTITUDE_TYPE): 'SPIN/NUTATION': the attitude types that are read in version 1.0 "
       "are"},
  };
  for (const Fault& fault : faults) {
    const std::string what = complaint_of(replaced(fault.text, fault.old, fault.by));
    const std::string expected =
        "attitude ephemeris message" + std::string{fault.reason.starts_with(",") ? "" : ", "} + fault.reason;
    EXPECT_EQ(what.substr(0, expected.size()), expected) << fault.old << " -> " << fault.by;
  }
}

TEST(AttitudeEphemerisMessage, DatesByTheDayOfTheYearWithZ) {
  const std::string text = replaced(replaced(spin, "SPIN/NUTATION", "EULER_ANGLE\nEULER_ROT_SEQ = 321"),
                                    " -109.9677896  0.366382445 18.16999799 -156.19211", "");
  const Segment segment = segment_of(text);
  EXPECT_EQ(segment.comments(),
            std::vector<std::string>{"             Spin KF ground solution, SPINKF rates "});
  EXPECT_EQ((segment.samples<Eme2000, Body>(body)[0].time), Epoch::from_utc("2006-03-31T05:00:00.071"));
  // Z is UTC, so that it contradicts another time system.
  EXPECT_NE(complaint_of(replaced(text, "UTC", "TAI")).find("line 23, column 1 (EPOCH)"), std::string::npos);
}

TEST(AttitudeEphemerisMessage, TheFileIsNamedAndMustBeWhole) {
  const TemporaryFile wrong(replaced(gmat_quaternions, "0.9240493645517975", "nan"));
  EXPECT_EQ(complaint([&] { Message::read(wrong.path()); }, wrong.path()),
            "attitude ephemeris message FILE, line 25, column 87 (QC): 'nan': not a finite number");
  const auto until = [](const std::string& end) {
    const TemporaryFile cut(gmat_quaternions.substr(0, gmat_quaternions.rfind(end)));
    return complaint([&] { Message::read(cut.path()); }, cut.path());
  };
  // Many files have no line end after DATA_STOP; nothing can be missing there.
  EXPECT_EQ(until("P\n"),
            "attitude ephemeris message FILE, line 28: the file stops within this line; it was "
            "truncated");
  const TemporaryFile whole(gmat_quaternions.substr(0, gmat_quaternions.size() - 1));
  EXPECT_EQ(Message::read(whole.path()).text(), Message::parse(gmat_quaternions).text());
  EXPECT_EQ(until("7093127769"),
            "attitude ephemeris message FILE, line 27: the file stops within this "
            "line; it was truncated");
  EXPECT_EQ(until("DATA_STOP"),
            "attitude ephemeris message FILE, the segment from line 5 on: there is no "
            "DATA_STOP");
  EXPECT_EQ(complaint([] { Message::read("/no/such/file"); }),
            "attitude ephemeris message /no/such/file: cannot be read");
}

TEST(AttitudeEphemerisMessage, ATextOfAMessageIsTheMessage) {
  for (const std::string& text : {gmat_quaternions, gmat_angles, tracker, rates}) {
    const std::string written = Message::parse(text).text();
    EXPECT_EQ(Message::parse(written).text(), written);
    const TemporaryFile file("");
    Message::parse(text).write(file.path());
    EXPECT_EQ(Message::read(file.path()).text(), written);
  }
  const std::string old = Message::parse(tracker).text(), newer = Message::parse(rates).text();
  for (const char* part : {"REF_FRAME_A = STARTRACKER_2\nREF_FRAME_B = GTOD\nATTITUDE_DIR = B2A\n",
                           "ATTITUDE_TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n",
                           "INTERPOLATION_METHOD = LINEAR\nINTERPOLATION_DEGREE = 1\n",
                           "1996-11-28T22:08:03.555 4.2319e-01 -4.5697e-01 2.3784e-01 7.4533e-01\n"})
    EXPECT_NE(old.find(part), std::string::npos) << part << old;
  for (const char* part : {"ATTITUDE_TYPE = QUATERNION/ANGVEL\nANGVEL_FRAME = REF_FRAME_B\n",
                           "COMMENT before the data\nCOMMENT between\n2021-04-15T13:31:20.000",
                           "ATTITUDE_TYPE = EULER_ANGLE\nEULER_ROT_SEQ = ZXZ\n", "CLASSIFICATION = public\n",
                           "9e+01 -4.5e+02 1e-300\n", "COMMENT between segments\n", "COMMENT at the end\n"})
    EXPECT_NE(newer.find(part), std::string::npos) << part << newer;
  EXPECT_EQ(newer.find("ATTITUDE_DIR"), std::string::npos);
}

// Random attitudes with and without rates, in both versions: the quaternions to the last bit, the rates,
// which are degrees in the file, to two roundings.
TEST(AttitudeEphemerisMessage, SamplesReadBackToTheLastBit) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  std::mt19937_64 random(20261129);
  std::normal_distribution<double> any;
  for (int run = 0; run < 200; ++run) {
    std::vector<AttitudeSample<Gcrf, Body, Epoch>> samples;
    std::vector<AngularVelocity<Gcrf, Body, In<Body>>> w;
    Epoch time = Epoch::from_utc("2016-12-31T23:59:55.123");
    for (int i = 0; i < 10; ++i) {
      const Eigen::Quaterniond q(any(random), any(random), any(random), std::pow(10.0, 3 * any(random)));
      samples.push_back({time, quaternion(to<Gcrf>, from<Body>, q.normalized())});
      w.push_back(angular_velocity(of<Body>, relative_to<Gcrf>,
                                   vectrix::vector<si::angular_velocity>(
                                       in<Body>, Eigen::Vector3d(any(random), any(random), any(random)))));
      time = Epoch::from_utc((time + 1.0 * si::second).utc(6));
    }
    const EphemerisMetadata metadata{"SHIP", "2026-001A"};
    const bool with_rates = run % 2 == 1;
    const Segment segment =
        with_rates ? Segment(metadata, samples, w, body) : Segment(metadata, samples, body);
    const Message message({run % 4 < 2 ? "1.0" : "2.0", "2026-11-29T00:00:00", "HERE"}, {segment});
    const Segment back = segment_of(message.text());
    const auto again = back.samples<Gcrf, Body>(body);
    ASSERT_EQ(again.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      EXPECT_EQ(again[i].time, samples[i].time);
      EXPECT_EQ(again[i].q_a_from_b.eigen().coeffs(), samples[i].q_a_from_b.eigen().coeffs());
    }
    if (!with_rates) continue;
    const auto w_again = back.angular_velocities<Gcrf, Body>(in<Body>, body);
    for (std::size_t i = 0; i < samples.size(); ++i)
      EXPECT_LE((w_again[i].coordinates() - w[i].coordinates()).norm(),
                roundings * w[i].coordinates().norm());
  }
}

TEST(AttitudeEphemerisMessage, SegmentsOfSamples) {
  const auto samples = segment_of(gmat_quaternions).samples<Eme2000, Body>(body);
  const EphemerisMetadata metadata{"SHIP", "2026-001A"};
  const Segment segment(metadata, samples, body);
  EXPECT_EQ(segment.ref_frame_a(), "EME2000");
  EXPECT_EQ(segment.ref_frame_b(), "SC_BODY_1");
  EXPECT_EQ(segment.metadata().stop_time, samples[2].time);
  const std::string place = "attitude ephemeris segment of 'SHIP': ";
  EXPECT_EQ(complaint([&] { Segment(metadata, samples, called<Body>("SC\nBODY")); }),
            place + "REF_FRAME_B 'SC\nBODY' is not one line of printable ASCII without blanks around it");
  EXPECT_EQ(complaint([&] { Segment(metadata, samples, called<Body>("eme2000")); }),
            place + "both frames have the name 'EME2000'");
  EXPECT_EQ(complaint([&] {
              Segment(metadata, std::vector{samples[1], samples[0]}, body);
            }),
            place + "sample 1 is not later than the one before");
  EXPECT_EQ(complaint([&] {
              Segment(metadata, samples, std::vector<AngularVelocity<Eme2000, Body, In<Body>>>{}, body);
            }),
            "attitude ephemeris segment: there are 3 samples and 0 rates");
  EXPECT_EQ(complaint([&] {
              Message({"1.1", "", ""}, {segment});
            }),
            "attitude ephemeris message: the version is '1.1'; the versions are 1.0, 2.0");
  EXPECT_EQ(complaint([&] {
              Message({"1.0", "", ""}, {});
            }),
            "attitude ephemeris message: there are no segments");
  EXPECT_EQ(
      complaint([&] {
        Message({"2.0", "", ""}, {segment_of(tracker)});
      }),
      "attitude ephemeris message, the segment from line 5 on: version 2.0 has the direction A2B and the "
      "scalar last; the segment has B2A");
  EXPECT_NE(complaint([&] {
              Message({"2.0", "", ""}, {segment_of(replaced(gmat_quaternions, "LAST", "FIRST"))});
            }).find("QUATERNION_TYPE FIRST"),
            std::string::npos);
}

}  // namespace
}  // namespace vectrix::attitude_ephemeris_message_test
