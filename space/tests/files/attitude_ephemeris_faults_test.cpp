#include "files/attitude_ephemeris_texts.hpp"

#include <algorithm>

namespace vectrix::attitude_ephemeris_message_test {
namespace {

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
       "line 1, column 11: a document type; it can name other files and entities, and is refused"},
      {gmat_quaternions, "CCSDS", "\xFF",
       "line 1, column 1: the byte 255 is no printable character of ASCII"},
      {gmat_quaternions, "CREATION", "MESSAGE_ID = 1\nCREATION",
       "line 2, column 14 (MESSAGE_ID): '1': the keyword is of version 2.0, the message of version 1.0"},
      {gmat_quaternions, "OBJECT_ID = NoId", "OBJECT_NAME = NoId",
       "line 8, column 15 (OBJECT_NAME): 'NoId': the keyword is there for the second time, after line 7"},
      {gmat_quaternions, "OBJECT_ID = NoId", "", "the segment from line 5 on: there is no OBJECT_ID"},
      {gmat_quaternions, "OBJECT_ID = NoId", "REF_FRAME = NoId",
       "line 8, column 13 (REF_FRAME): 'NoId': the keyword is not of the standard, but nearly REF_FRAME_A"},
      {gmat_quaternions, "REF_FRAME_A = EME2000", "", "the segment from line 5 on: there is no REF_FRAME_A"},
      {gmat_quaternions, "REF_FRAME_B = SC_BODY_1",
       "REF_FRAME_B =", "line 11, column 14 (REF_FRAME_B): '': it is empty"},
      {gmat_quaternions, "REF_FRAME_B = SC_BODY_1", "REF_FRAME_B = eme2000",
       "line 11, column 15 (REF_FRAME_B): 'eme2000': it is REF_FRAME_A, too"},
      {gmat_quaternions, "ATTITUDE_DIR = A2B", "", "the segment from line 5 on: there is no ATTITUDE_DIR"},
      {gmat_quaternions, "A2B", "A2C", "line 12, column 16 (ATTITUDE_DIR): 'A2C': it is A2B or B2A"},
      {gmat_quaternions, "1.0", "2.0",
       "line 12, column 16 (ATTITUDE_DIR): 'A2B': the keyword is of version 1.0, the message of version 2.0"},
      {gmat_quaternions, "UTC", "MRT",
       "line 13, column 15 (TIME_SYSTEM): 'MRT': the time systems that are read are UTC, TAI, TT, TDB and "
       "GPS"},
      {gmat_quaternions, "UTC", "GMST",
       "line 13, column 15 (TIME_SYSTEM): 'GMST': the time systems that are read are UTC, TAI, TT, TDB and "
       "GPS"},
      {gmat_quaternions, "START_TIME         = 2000-01-01T11:59:28.000", "START_TIME = 2000-01-01T11:59:60",
       "line 14, column 14 (START_TIME): '2000-01-01T11:59:60': epoch '2000-01-01T11:59:60' in UTC: there is "
       "no such second"},
      {gmat_quaternions, "STOP_TIME  = 2000-01-01T12:59:27.061", "STOP_TIME  = 2000-01-01T13:59:27.061",
       "line 17, column 22 (STOP_TIME): '2000-01-01T12:59:27.061': it is before USEABLE_STOP_TIME, "
       "2000-01-01T13:59:27.061"},
      {gmat_quaternions, "ATTITUDE_TYPE = QUATERNION", "",
       "the segment from line 5 on: there is no ATTITUDE_TYPE"},
      {gmat_quaternions, "= QUATERNION", "= DCM",
       "line 18, column 17 (ATTITUDE_TYPE): 'DCM': the attitude types that are read in version 1.0 are "
       "QUATERNION, QUATERNION/DERIVATIVE, QUATERNION/RATE, EULER_ANGLE"},
      {gmat_quaternions, "= QUATERNION", "= QUATERNION/ANGVEL",
       "line 18, column 17 (ATTITUDE_TYPE): 'QUATERNION/ANGVEL': the attitude types that are read in version "
       "1.0 are QUATERNION, QUATERNION/DERIVATIVE, QUATERNION/RATE, EULER_ANGLE"},
      {gmat_quaternions, "= QUATERNION", "= QUATERNION/RATE",
       "the segment from line 5 on: there is no RATE_FRAME"},
      {gmat_quaternions, "QUATERNION_TYPE = LAST", "",
       "the segment from line 5 on: there is no QUATERNION_TYPE"},
      {gmat_quaternions, "= LAST", "= SECOND",
       "line 19, column 19 (QUATERNION_TYPE): 'SECOND': it is FIRST or LAST"},
      {gmat_quaternions, "DEGREE = 7", "DEGREE = -7",
       "line 21, column 24 (INTERPOLATION_DEGREE): '-7': not a whole number"},
      {gmat_quaternions, "DATA_START", "",
       "line 25, column 1: '2000-01-01T11:59:28.000 0.1952861484651402  -0.0794601632166...': expected "
       "DATA_START"},
      {gmat_quaternions, "DATA_STOP\n", "", "the segment from line 5 on: there is no DATA_STOP"},
      {gmat_quaternions, "DATA_STOP\n", "META_START\n",
       "line 28, column 1: 'META_START': no line of data, and not DATA_STOP"},
      {gmat_quaternions, "DATA_STOP\n", "DATA_STOP\nX\n",
       "line 29, column 1: 'X': expected META_START after DATA_STOP"},
      {gmat_quaternions, "DATA_STOP\n", "USER_DEFINED_TEST_KEY = bad\n",
       "line 28, column 1: 'USER_DEFINED_TEST_KEY = bad': no line of data, and not DATA_STOP"},
      {gmat_quaternions, "DATA_START\n", "DATA_START\nDATA_STOP\n",
       "the segment from line 5 on: there are no data lines"},
      {gmat_quaternions, "12:00:28.000 0.19", "11:59:28.000 0.19",
       "line 26, column 1 (EPOCH): '2000-01-01T11:59:28.000': not later than the line before, at "
       "2000-01-01T11:59:28.000"},
      {gmat_quaternions, "2000-01-01T12:02:02.637", "2000-01-01T13:02:02.637",
       "line 27, column 1 (EPOCH): '2000-01-01T13:02:02.637': outside START_TIME, 2000-01-01T11:59:28.000, "
       "and STOP_TIME, 2000-01-01T12:59:27.061"},
      data("2000-01-01T11:59:28.000 0.6 0 0",
           "1: '2000-01-01T11:59:28.000 0.6 0 0': 4 fields; a line of QUATERNION has an epoch and 4 numbers"),
      data("2000-01-01T11:59:28.000 0.6 0 0 0.8 1",
           "1: '2000-01-01T11:59:28.000 0.6 0 0 0.8 1': 6 fields; a line of QUATERNION has an epoch and 4 "
           "numbers"),
      data("2000-01-01T11:59:28.000 0.6 0 nan 0.8", "31 (Q3): 'nan': not a finite number"),
      data("2000-01-01T11:59:28.000 0.6 0 0 0.8D0",
           "33 (QC): '0.8D0': its exponent has the letter D, where E is needed"),
      data("2000-01-01T11:59:28.000 0.6 -inf 0 0.8", "29 (Q2): '-inf': not a finite number"),
      data("2000-01-01T11:59:28.000 3735472A^0 0 0 0.8", "25 (Q1): '3735472A^0': not a finite number"),
      data("2000-01-01T11:59:28.000 0.6 0 0 0.6",
           "25 (Q1): '0.6': of a quaternion whose norm is 0.848528137423857; it may differ from 1 by 0.01"),
      data("2000-01-01T11:59:28.000 1200000000 0 0 1600000000",
           "25 (Q1): '1200000000': of a quaternion whose norm is 2e+09; it may differ from 1 by 0.01"),
      data("2000-01-01T11:59:28.000 0 0 0 0",
           "25 (Q1): '0': of a quaternion whose norm is 0; it may differ from 1 by 0.01"),
      data("2000-01-01 0.6 0 0 0.8",
           "1 (EPOCH): '2000-01-01': epoch '2000-01-01' in UTC: it is not written as "
           "2022-04-14T10:22:11.874999"),
      {gmat_angles, "EULER_ROT_SEQ = 321", "", "the segment from line 5 on: there is no EULER_ROT_SEQ"},
      {gmat_angles, "321", "322",
       "line 16, column 17 (EULER_ROT_SEQ): '322': no sequence of three axes such as 321 or ZYX, none twice "
       "in a row"},
      {gmat_angles, "321", "XYA",
       "line 16, column 17 (EULER_ROT_SEQ): 'XYA': no sequence of three axes such as 321 or ZYX, none twice "
       "in a row"},
      {gmat_angles, "18.80387738364443", "1e999",
       "line 22, column 63 (ANGLE_3): '1e999': too large or too small for a double, 5e-324 to 1.8e308"},
      {rates, "ANGVEL_FRAME = REF_FRAME_B", "", "the segment from line 7 on: there is no ANGVEL_FRAME"},
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
       "are QUATERNION, QUATERNION/DERIVATIVE, QUATERNION/RATE, EULER_ANGLE; what the numbers of this one "
       "mean, "
       "version 1.0 does not say"},
  };
  for (const Fault& fault : faults) {
    const std::string what = complaint_of(replaced(fault.text, fault.old, fault.by));
    EXPECT_EQ(what, "attitude ephemeris message, " + fault.reason) << fault.old << " -> " << fault.by;
  }
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
  std::string returns = gmat_quaternions;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  const TemporaryFile bare(returns);
  EXPECT_EQ(
      complaint([&] { Message::read(bare.path()); }, bare.path()),
      "attitude ephemeris message FILE, line 1: its lines end with CR alone; they must end with LF or CR LF");
  EXPECT_EQ(until("DATA_STOP"),
            "attitude ephemeris message FILE, the segment from line 5 on: there is no "
            "DATA_STOP");
  EXPECT_EQ(complaint([] { Message::read("/no/such/file"); }),
            "attitude ephemeris message /no/such/file: cannot be read");
}

}  // namespace
}  // namespace vectrix::attitude_ephemeris_message_test
