#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include <vectrix/space.hpp>

#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix::attitude_parameter_message_test {
namespace {

using earth::Eme2000, earth::Itrf;
using Message = AttitudeParameterMessage;

struct Body : moving_frame {};
struct Instrument : moving_frame {};

constexpr double degree = std::numbers::pi / 180.0;

// Of CS-SI/Orekit (at fe4aee84, Apache-2.0): the quaternion and the Euler angles are not the same attitude.
const std::string two_forms = R"(CCSDS_APM_VERS  = 1.0
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
const std::string blocks = R"(CCSDS_APM_VERS = 2.0
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

std::string complaint_of(const std::string& text) {
  return complaint([&] { Message::parse(text); });
}

// Nothing merges the two: they are 130 deg apart.
TEST(AttitudeParameterMessage, TwoFormsOfVersion1AreBothKept) {
  const auto message = Message::parse(two_forms);
  EXPECT_EQ(message.epoch().utc(4), "2004-02-14T14:28:15.1172");
  EXPECT_EQ(message.metadata().object_name, "MARS SPIRIT");
  ASSERT_EQ(message.states().size(), 2U);
  EXPECT_EQ(message.states()[0].ref_frame_a(), "INSTRUMENT_A");
  EXPECT_EQ(message.states()[1].ref_frame_a(), "ITRF-97");
  const auto instrument = called<Instrument>("INSTRUMENT_A");
  const auto quaternion = message.states()[0].nearest_samples<Itrf, Instrument>(instrument);
  const auto angles = message.states()[1].samples<Itrf, Instrument>(instrument);
  EXPECT_EQ(quaternion.samples.front().time, message.epoch());
  EXPECT_LT(quaternion.distance, 1e-5);  // of five digits

  // A2B from the instrument to ITRF, and the other way round: q_b^a is Hamilton's product of the half turns.
  const Eigen::Quaterniond q(0.47832, 0.03123, 0.78543, 0.39158);
  constexpr double rounding = 1e-7;  // angularDistance near 0 is the root of a rounding
  EXPECT_LT(quaternion.samples.front().q_a_from_b.eigen().angularDistance(q.conjugate().normalized()),
            rounding);
  const Eigen::Quaterniond e = Eigen::AngleAxisd(-53.3688 * degree, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(139.7527 * degree, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(25.0658 * degree, Eigen::Vector3d::UnitY());
  EXPECT_LT(angles.front().q_a_from_b.eigen().angularDistance(e), rounding);
  constexpr double apart = 130.0, rounded = 1.0;  // published as a whole number of degrees
  EXPECT_NEAR(e.angularDistance(quaternion.samples.front().q_a_from_b.eigen()) / degree, apart, rounded);
}

TEST(AttitudeParameterMessage, OtherBlocksAreNumbersWithNames) {
  const auto message = Message::parse(two_forms);
  ASSERT_EQ(message.blocks().size(), 5U);
  const auto inertia = message.blocks("inertia");
  ASSERT_EQ(inertia.size(), 1U);
  EXPECT_EQ(inertia[0].number("I11"), 6080.0);
  EXPECT_EQ(inertia[0].number("I12"), -135.9);
  EXPECT_EQ(inertia[0].comments, std::vector<std::string>{"          Spacecraft Parameters"});
  const auto manoeuvres = message.blocks("manoeuvre");
  ASSERT_EQ(manoeuvres.size(), 1U);
  EXPECT_EQ(manoeuvres[0].number("MAN_TOR_2"), -0.5);
  EXPECT_EQ(*manoeuvres[0].text("MAN_REF_FRAME"), "INSTRUMENT_A");
  EXPECT_EQ(message.blocks("Euler angles")[0].number("Y_RATE"), 0.03214);
  EXPECT_EQ(complaint([&] { static_cast<void>(inertia[0].number("IXX")); }), "the inertia: there is no IXX");
  EXPECT_EQ(complaint([&] { static_cast<void>(manoeuvres[0].number("MAN_REF_FRAME")); }),
            "the manoeuvre, MAN_REF_FRAME: 'INSTRUMENT_A': not a finite number");
  EXPECT_EQ(inertia[0].text("MASS"), nullptr);
  const auto two = Message::parse(two_forms + two_forms.substr(two_forms.find("MAN_EPOCH")));
  EXPECT_EQ(two.blocks("manoeuvre").size(), 2U);
}

TEST(AttitudeParameterMessage, BlocksOfVersion2) {
  const auto message = Message::parse(blocks);
  ASSERT_EQ(message.states().size(), 4U);
  const auto body = called<Body>("SC_BODY_1");
  const auto q = message.states()[0].samples<Eme2000, Body>(body).front().q_a_from_b.eigen();
  EXPECT_EQ(q.w(), 0.8);
  EXPECT_EQ(q.z(), 0.6);
  EXPECT_EQ(message.states()[1].ref_frame_b(), "STARTRACKER_2");
  const auto angles = message.states()[2].samples<Eme2000, Body>(body).front().q_a_from_b.eigen();
  const Eigen::Quaterniond b_from_a = Eigen::AngleAxisd(10 * degree, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(20 * degree, Eigen::Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(30 * degree, Eigen::Vector3d::UnitZ());
  constexpr double rounding = 1e-7;  // as above
  EXPECT_LT(angles.angularDistance(b_from_a.conjugate()), rounding);

  const AttitudeEphemerisSegment& turning = message.states()[3];
  const auto w = turning.angular_velocities<Eme2000, Body>(in<Body>, body).front();
  EXPECT_LT((w.coordinates() - degree * Eigen::Vector3d(1, -2, 3)).norm(), 1e-15);
  EXPECT_EQ(
      (turning.angular_velocities<Body, Eme2000>(in<Body>, body).front().coordinates() + w.coordinates())
          .norm(),
      0.0);
  EXPECT_EQ(
      complaint([&] { static_cast<void>(turning.samples<Eme2000, Body>(body)); }),
      "attitude parameter message, the angular velocity from line 51 on: there is an angular velocity, but "
      "no attitude");
  EXPECT_NE(complaint([&] {
              static_cast<void>(turning.angular_velocities<Eme2000, Body>(in<Eme2000>, body));
            }).find("the rates are in REF_FRAME_B, 'SC_BODY_1'; asked for 'EME2000'"),
            std::string::npos);

  EXPECT_EQ(message.header().others, (std::vector<OtherKeyword>{{"MISSION_PHASE", "cruise, 2"}}));
  EXPECT_EQ(message.metadata().others, (std::vector<OtherKeyword>{{"ZEROTH", "= [m]"}}));
  EXPECT_EQ(*message.blocks("manoeuvre")[0].text("USER_DEFINED_VALVE"), "3");
  EXPECT_EQ(message.blocks("spin")[0].number("NUTATION_VEL"), 7.0);
}

TEST(AttitudeParameterMessage, FramesThatWereNotAskedForAreRefused) {
  const auto message = Message::parse(two_forms);
  EXPECT_EQ(
      complaint([&] {
        static_cast<void>(message.states()[0].samples<Eme2000, Body>(called<Body>("INSTRUMENT_A")));
      }),
      "attitude parameter message, the quaternion from line 11 on: Q_FRAME_A is 'INSTRUMENT_A', Q_FRAME_B is "
      "'ITRF-97'; asked for 'INSTRUMENT_A' (" +
          frame_name<Body>() + ") relative to 'EME2000' (earth::Eme2000)");
  EXPECT_NE(complaint([&] {
              static_cast<void>(message.states()[1].samples<Itrf, Body>(called<Body>("SC_BODY_1")));
            }).find("EULER_FRAME_A is 'ITRF-97', EULER_FRAME_B is 'INSTRUMENT_A'; asked for 'SC_BODY_1'"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              static_cast<void>(message.states()[0].samples<Itrf, Body>(called<Body>("INSTRUMENT_A")));
            }).find(", line 15: the norm of the quaternion differs from 1 by "),
            std::string::npos);
}

TEST(AttitudeParameterMessage, TextReadsBack) {
  for (const std::string& text : {two_forms, blocks}) {
    const std::string written = Message::parse(text).text();
    const auto again = Message::parse(written);
    EXPECT_EQ(again.text(), written);
    EXPECT_EQ(again.blocks().size(), Message::parse(text).blocks().size());
    for (std::size_t i = 0; i < again.blocks().size(); ++i) {
      EXPECT_EQ(again.blocks()[i].entries, Message::parse(text).blocks()[i].entries);
      EXPECT_EQ(again.blocks()[i].comments, Message::parse(text).blocks()[i].comments);
    }
  }
  // The text of this one is canonical, but for a comment at the end of a block.
  EXPECT_EQ(Message::parse(blocks).text(), replaced(replaced(blocks, "= 3\nCOMMENT at the end", "= 3"),
                                                    "MAN_START\n", "MAN_START\nCOMMENT at the end\n"));
  const TemporaryFile file("");
  Message::parse(blocks).write(file.path());
  EXPECT_EQ(Message::read(file.path()).text(), Message::parse(blocks).text());
}

TEST(AttitudeParameterMessage, OfOwnStates) {
  const Epoch t = Epoch::from_utc("2026-11-29T00:00:00");
  const std::vector<AttitudeSample<Eme2000, Body, Epoch>> samples{
      {t, quaternion_scalar_first(to<Eme2000>, from<Body>, 0.8, 0.6, 0.0, 0.0)}};
  const std::vector w{
      angular_velocity(of<Body>, relative_to<Eme2000>,
                       vector(in<Body>, 0.1 * (si::radian / si::second), 0.2 * (si::radian / si::second),
                              0.3 * (si::radian / si::second)))};
  const auto body = called<Body>("SC_BODY_1");
  const AttitudeEphemerisSegment segment({"SATELLITE", "2026-001A"}, samples, w, body);
  const Message message({"2.0", "2026-11-29T00:00:00", "HERE"}, {segment});
  ASSERT_EQ(message.states().size(), 2U);
  const Message again = Message::parse(message.text());
  EXPECT_EQ(again.epoch(), t);
  const auto q = again.states()[0].samples<Eme2000, Body>(body).front().q_a_from_b;
  EXPECT_EQ(q.eigen().coeffs(), samples.front().q_a_from_b.eigen().coeffs());
  constexpr double rounding = 1e-16;  // to degrees and back
  EXPECT_LT((again.states()[1].angular_velocities<Eme2000, Body>(in<Body>, body).front().coordinates() -
             w.front().coordinates())
                .norm(),
            rounding);

  EXPECT_NE(complaint([&] {
              Message({"1.0", "", ""}, {segment});
            }).find("a message of segments has 2.0"),
            std::string::npos);
  EXPECT_NE(complaint([&] {
              Message({"2.0", "", ""}, {});
            }).find("there are no segments"),
            std::string::npos);
  auto two = samples;
  two.push_back({t + 1.0 * si::second, two.front().q_a_from_b});
  EXPECT_NE(complaint([&] {
              Message({"2.0", "", ""}, {AttitudeEphemerisSegment({"SATELLITE", "2026-001A"}, two, body)});
            }).find("a state has one sample"),
            std::string::npos);
}

struct Fault {
  const std::string& text;
  std::string old, by, reason;
};

TEST(AttitudeParameterMessage, EveryFaultHasALineAColumnAndAReason) {
  const Fault faults[] = {
      {two_forms, "1.0", "3.0", "line 1, column 19 (CCSDS_APM_VERS): '3.0': the versions are 1.0, 2.0"},
      {two_forms, "OBJECT_ID       = 2004-003A", "", "the message: there is no OBJECT_ID"},
      {two_forms, "= UTC", "= GMST",
       "line 8, column 19 (TIME_SYSTEM): 'GMST': the time systems that are read are UTC, TAI, TT, TDB and "
       "GPS"},
      {two_forms, "2004-02-14T14:28:15.1172", "2004-02-30T14:28:15",
       "line 10, column 19 (EPOCH): '2004-02-30T14:28:15': epoch '2004-02-30T14:28:15' in UTC: there is no "
       "such "
       "day"},
      {two_forms, "Q3              = 0.39158\n", "", "the quaternion from line 11 on: there is no Q3"},
      {two_forms, "0.39158", "0.39158D0", "line 17, column 19 (Q3): '0.39158D0': not a finite number"},
      {two_forms, "0.39158", "0.89158",
       "line 15, column 19 (Q1): '0.03123': of a quaternion whose norm is 1.2812417869395303; it may differ "
       "from 1 "
       "by 0.01"},
      {two_forms, "Q_DIR           = A2B", "Q_DIR = A2C",
       "line 13, column 9 (Q_DIR): 'A2C': it is A2B or B2A"},
      {two_forms, "Q_FRAME_B       = ITRF-97", "Q_FRAME_B = instrument_a",
       "line 12, column 13 (Q_FRAME_B): 'instrument_a': it is Q_FRAME_A, too"},
      {two_forms, "= 312", "= 322",
       "line 24, column 19 (EULER_ROT_SEQ): '322': no sequence of three axes such as 321 or ZYX, none twice "
       "in a "
       "row"},
      {two_forms, "= 312", "= 313",
       "line 24, column 19 (EULER_ROT_SEQ): '313': there is no Z_ANGLE for each of its turns"},
      {two_forms, "Y_ANGLE         = 25.0658", "Z_ANGLE = 25.0658",
       "line 24, column 19 (EULER_ROT_SEQ): '312': there is no Y_ANGLE for each of its turns"},
      {two_forms, "Y_RATE", "Y_ANGLE         = 1\nY_RATE",
       "line 31, column 19 (Y_ANGLE): '1': EULER_ROT_SEQ, 312, has no turn for it"},
      {two_forms, "-53.3688", "-53.3688 [rad]",
       "line 26, column 19 (Z_ANGLE): '-53.3688 [rad]': the unit is [deg]"},
      {two_forms, "I11 ", "IXX ",
       "line 34, column 21 (IXX): '6080.0': the keyword is of version 2.0, the message of version 1.0"},
      {two_forms, "I12               = -135.9\n", "", "the inertia from line 34 on: there is no I12"},
      {two_forms, "MAN_EPOCH_START = 2004-02-14T14:29:00.5098\n", "",
       "line 42, column 19 (MAN_DURATION): '3': the manoeuvre begins with MAN_EPOCH_START"},
      {two_forms, "MAN_DURATION    = 3", "MAN_DURATION    = 3 [m]",
       "line 43, column 19 (MAN_DURATION): '3 [m]': the unit is [s]"},
      {two_forms, "MAN_TOR_3       = 0.5", "MAN_TOR_2       = 0.5",
       "line 47, column 19 (MAN_TOR_2): '0.5': the keyword is there for the second time, after line 46"},
      {two_forms, "MAN_TOR_3", "MAN_TORR_3",
       "line 47, column 20 (MAN_TORR_3): '0.5': the keyword is not of the standard, but nearly MAN_TOR_3"},
      {two_forms, "MAN_TOR_3       = 0.5", "MAN_TOR_3",
       "line 47, column 1: 'MAN_TOR_3': expected keyword = value"},
      {two_forms, "EULER_DIR", "OBJECT_NAME",
       "line 23, column 21 (OBJECT_NAME): 'A2B': the keyword has its place in another part of the message"},
      {blocks, "QUAT_STOP\n\nQUAT_START", "QUAT_STOP",
       "line 31, column 15 (REF_FRAME_A): 'EME2000': the keyword has "
       "its place behind QUAT_START"},
      {blocks, "QUAT_STOP\n", "", "line 31, column 1: 'QUAT_START': expected QUAT_STOP"},
      {blocks, "QUAT_STOP\n", "EULER_STOP\n", "line 30, column 1: 'EULER_STOP': expected QUAT_STOP"},
      {blocks, "QUAT_START\n", "QUAT_STOP\n",
       "line 18, column 1: 'QUAT_STOP': there is no QUAT_START before it"},
      {blocks, "MAN_STOP\n", "", "the manoeuvre from line 82 on: there is no MAN_STOP"},
      {blocks, "Q3 = .6", "I11 = .6",
       "line 24, column 7 (I11): '.6': the keyword has its place in another part of "
       "the message"},
      {blocks, "IXY", "I12",
       "line 77, column 7 (I12): '-135.9': the keyword is of version 1.0, the message of "
       "version 2.0"},
      {blocks, "ANGVEL_FRAME = SC_BODY_1", "ANGVEL_FRAME = GCRF",
       "line 54, column 16 (ANGVEL_FRAME): 'GCRF': it is REF_FRAME_A or REF_FRAME_B"},
      {blocks, "REF_FRAME_A = EME2000", "REF_FRAME_A =", "line 20, column 14 (REF_FRAME_A): '': it is empty"},
      {blocks, "[kg*m**2]", "[kg*m**3]",
       "line 74, column 7 (IXX): '6080.0 [kg*m**3]': the unit is [kg*m**2]"},
      {blocks, "IXX = 6080.0", "IXX = -6080.0",
       "line 74, column 7 (IXX): '-6080.0 [kg*m**2]': it is negative"}};
  for (const auto& [text, old, by, reason] : faults)
    EXPECT_EQ(complaint_of(replaced(text, old, by)), "attitude parameter message, " + reason) << by;
  EXPECT_EQ(complaint_of(replaced(two_forms, "EPOCH           = 2004-02-14T14:28:15.1172", "")),
            "attitude parameter message: there is no EPOCH");
  EXPECT_EQ(complaint_of(two_forms.substr(0, two_forms.find("Q_FRAME_A"))),
            "attitude parameter message: there is an EPOCH, but no attitude");
  EXPECT_EQ(complaint_of(two_forms.substr(0, two_forms.find("COMMENT  "))),
            "attitude parameter message: there are no data");
}

TEST(AttitudeParameterMessage, RepeatedAxesAreInTheOrderOfTheirLines) {
  const auto text = replaced(replaced(two_forms, "= 312", "= 313"), "Y_ANGLE ", "Z_ANGLE ");
  const auto q =
      Message::parse(text).states()[1].samples<Itrf, Instrument>(called<Instrument>("INSTRUMENT_A"));
  const Eigen::Quaterniond e = Eigen::AngleAxisd(-53.3688 * degree, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(139.7527 * degree, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(25.0658 * degree, Eigen::Vector3d::UnitZ());
  EXPECT_LT(q.front().q_a_from_b.eigen().angularDistance(e), 1e-7);
  EXPECT_EQ(Message::parse(Message::parse(text).text()).text(), Message::parse(text).text());
}

// The published file has no line end at its end. Cut before its last value it lacks something.
TEST(AttitudeParameterMessage, AFileWithoutALastLineEnd) {
  const TemporaryFile published(two_forms.substr(0, two_forms.size() - 1));
  EXPECT_EQ(Message::read(published.path()).text(), Message::parse(two_forms).text());
  const TemporaryFile cut(two_forms.substr(0, two_forms.find("MAN_TOR_3") + 5));
  EXPECT_EQ(complaint([&] { Message::read(cut.path()); }, cut.path()),
            "attitude parameter message FILE, line 47, column 1: 'MAN_T': expected keyword = value");
}

}  // namespace
}  // namespace vectrix::attitude_parameter_message_test
