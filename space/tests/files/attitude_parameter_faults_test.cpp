#include <gtest/gtest.h>

#include <string>

#include "files/attitude_parameter_texts.hpp"
#include "files/faults.hpp"
#include "files/replaced.hpp"
#include "temporary_file.hpp"

namespace vectrix::attitude_parameter_message_test {
namespace {

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

TEST(AttitudeParameterMessage, EveryFaultHasALineAColumnAndAReason) {
  const std::string kind = "attitude parameter message";
  expect_faults<Message>(
      two_forms, kind,
      {{"1.0", "3.0", "line 1, column 19 (CCSDS_APM_VERS): '3.0': the versions are 1.0, 2.0"},
       {"OBJECT_ID       = 2004-003A", "", "the message: there is no OBJECT_ID"},
       {"= UTC", "= GMST",
        "line 8, column 19 (TIME_SYSTEM): 'GMST': the time systems that are read are UTC, TAI, TT, TDB and "
        "GPS"},
       {"2004-02-14T14:28:15.1172", "2004-02-30T14:28:15",
        "line 10, column 19 (EPOCH): '2004-02-30T14:28:15': epoch '2004-02-30T14:28:15' in UTC: there is no "
        "such "
        "day"},
       {"Q3              = 0.39158\n", "", "the quaternion from line 11 on: there is no Q3"},
       {"0.39158", "0.39158D0",
        "line 17, column 19 (Q3): '0.39158D0': its exponent has the letter D, where E is needed"},
       {"0.39158", "0.89158",
        "line 15, column 19 (Q1): '0.03123': of a quaternion whose norm is 1.2812417869395303; it may differ "
        "from 1 "
        "by 0.01"},
       {"Q_DIR           = A2B", "Q_DIR = A2C", "line 13, column 9 (Q_DIR): 'A2C': it is A2B or B2A"},
       {"Q_FRAME_B       = ITRF-97", "Q_FRAME_B = instrument_a",
        "line 12, column 13 (Q_FRAME_B): 'instrument_a': it is Q_FRAME_A, too"},
       {"= 312", "= 322",
        "line 24, column 19 (EULER_ROT_SEQ): '322': no sequence of three axes such as 321 or ZYX, none twice "
        "in a "
        "row"},
       {"= 312", "= 313",
        "line 24, column 19 (EULER_ROT_SEQ): '313': there is no Z_ANGLE for each of its turns"},
       {"Y_ANGLE         = 25.0658", "Z_ANGLE = 25.0658",
        "line 24, column 19 (EULER_ROT_SEQ): '312': there is no Y_ANGLE for each of its turns"},
       {"Y_RATE", "Y_ANGLE         = 1\nY_RATE",
        "line 31, column 19 (Y_ANGLE): '1': EULER_ROT_SEQ, 312, has no turn for it"},
       {"-53.3688", "-53.3688 [rad]", "line 26, column 19 (Z_ANGLE): '-53.3688 [rad]': the unit is [deg]"},
       {"I11 ", "IXX ",
        "line 34, column 21 (IXX): '6080.0': the keyword is of version 2.0, the message of version 1.0"},
       {"I12               = -135.9\n", "", "the inertia from line 34 on: there is no I12"},
       {"MAN_EPOCH_START = 2004-02-14T14:29:00.5098\n", "",
        "line 42, column 19 (MAN_DURATION): '3': the manoeuvre begins with MAN_EPOCH_START"},
       {"MAN_DURATION    = 3", "MAN_DURATION    = 3 [m]",
        "line 43, column 19 (MAN_DURATION): '3 [m]': the unit is [s]"},
       {"MAN_TOR_3       = 0.5", "MAN_TOR_2       = 0.5",
        "line 47, column 19 (MAN_TOR_2): '0.5': the keyword is there for the second time, after line 46"},
       {"MAN_TOR_3", "MAN_TORR_3",
        "line 47, column 20 (MAN_TORR_3): '0.5': the keyword is not of the standard, but nearly MAN_TOR_3"},
       {"MAN_TOR_3       = 0.5", "MAN_TOR_3", "line 47, column 1: 'MAN_TOR_3': expected keyword = value"},
       {"EULER_DIR", "OBJECT_NAME",
        "line 23, column 21 (OBJECT_NAME): 'A2B': the keyword has its place in another part of the "
        "message"}});
  expect_faults<Message>(
      blocks, kind,
      {{"QUAT_STOP\n\nQUAT_START", "QUAT_STOP",
        "line 31, column 15 (REF_FRAME_A): 'EME2000': the keyword has "
        "its place behind QUAT_START"},
       {"QUAT_STOP\n", "", "line 31, column 1: 'QUAT_START': expected QUAT_STOP"},
       {"QUAT_STOP\n", "EULER_STOP\n", "line 30, column 1: 'EULER_STOP': expected QUAT_STOP"},
       {"QUAT_START\n", "QUAT_STOP\n", "line 18, column 1: 'QUAT_STOP': there is no QUAT_START before it"},
       {"MAN_STOP\n", "", "the manoeuvre from line 82 on: there is no MAN_STOP"},
       {"Q3 = .6", "I11 = .6",
        "line 24, column 7 (I11): '.6': the keyword has its place in another part of "
        "the message"},
       {"IXY", "I12",
        "line 77, column 7 (I12): '-135.9': the keyword is of version 1.0, the message of "
        "version 2.0"},
       {"ANGVEL_FRAME = SC_BODY_1", "ANGVEL_FRAME = GCRF",
        "line 54, column 16 (ANGVEL_FRAME): 'GCRF': it is REF_FRAME_A or REF_FRAME_B"},
       {"REF_FRAME_A = EME2000", "REF_FRAME_A =", "line 20, column 14 (REF_FRAME_A): '': it is empty"},
       {"[kg*m**2]", "[kg*m**3]", "line 74, column 7 (IXX): '6080.0 [kg*m**3]': the unit is [kg*m**2]"},
       {"IXX = 6080.0", "IXX = -6080.0", "line 74, column 7 (IXX): '-6080.0 [kg*m**2]': it is negative"}});
  EXPECT_EQ(complaint_of<Message>(replaced(two_forms, "EPOCH           = 2004-02-14T14:28:15.1172", "")),
            "attitude parameter message: there is no EPOCH");
  EXPECT_EQ(complaint_of<Message>(two_forms.substr(0, two_forms.find("Q_FRAME_A"))),
            "attitude parameter message: there is an EPOCH, but no attitude");
  EXPECT_EQ(complaint_of<Message>(two_forms.substr(0, two_forms.find("COMMENT  "))),
            "attitude parameter message: there are no data");
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
