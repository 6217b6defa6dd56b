#include "files/orbit_ephemeris_texts.hpp"

namespace vectrix::orbit_ephemeris_message_test {
namespace {

struct Fault {
  std::string old, by, reason;
};

// Of the message `full`, with one thing wrong: the place and the reason.
TEST(OrbitEphemerisMessage, EveryFaultHasALineAColumnAndAReason) {
  const std::string line = "1996-12-18T12:00:00.331 2789.619 -.280045 +1746.755 4.73372";
  const auto data = [&](const std::string& by, const std::string& reason) {
    return Fault{line, by, "line 21, column " + reason};
  };
  const Fault faults[] = {
      {"3.0", "4.0", "line 1, column 18 (CCSDS_OEM_VERS): '4.0': the versions are 1.0, 2.0, 3.0"},
      {"3.0", "2.0",
       "line 2, column 18 (CLASSIFICATION): 'public, test-data': the keyword is of version 3.0, the message "
       "of version 2.0"},
      {"CCSDS_OEM_VERS", "CCSDS_AEM_VERS",
       "line 1, column 18 (CCSDS_AEM_VERS): '3.0': a message begins with CCSDS_OEM_VERS"},
      {"CCSDS_OEM_VERS = 3.0", "OEM", "line 1, column 1: 'OEM': a message begins with CCSDS_OEM_VERS"},
      {"ORIGINATOR = HERE", "ORIGINATR = HERE",
       "line 4, column 13 (ORIGINATR): 'HERE': the keyword is not of the standard, but nearly ORIGINATOR"},
      {"ORIGINATOR = HERE", "STOP_TIME = HERE",
       "line 4, column 13 (STOP_TIME): 'HERE': the keyword has its place in another part of the message"},
      {"ORIGINATOR = HERE", "CREATION_DATE = HERE",
       "line 4, column 17 (CREATION_DATE): 'HERE': the keyword is there for the second time, after line 3"},
      {"ORIGINATOR = HERE", "ORIGINATOR", "line 4, column 1: 'ORIGINATOR': expected keyword = value"},
      {"META_STOP", "",
       "line 21, column 1: '1996-12-18T12:00:00.331 2789.619 -.280045 +1746.755 4.73372 ...': expected "
       "keyword = value"},
      {"OBJECT_NAME = ORBITER [A]", "OBJECT_NAM = X",
       "line 9, column 14 (OBJECT_NAM): 'X': the keyword is not of the standard, but nearly OBJECT_NAME"},
      {"OBJECT_NAME = ORBITER [A]", "ORIGINATOR = X",
       "line 9, column 14 (ORIGINATOR): 'X': the keyword has its place in another part of the message"},
      {"OBJECT_NAME = ORBITER [A]", "CCSDS_OEM_VERS = 3.0",
       "line 9, column 18 (CCSDS_OEM_VERS): '3.0': the keyword has its place in another part of the message"},
      {"OBJECT_NAME = ORBITER [A]", "META_STOP = X",
       "line 9, column 13 (META_STOP): 'X': the keyword has its place in another part of the message"},
      {"OBJECT_NAME = ORBITER [A]", "MY_KEY = 1\nMY_KEY = 1",
       "line 10, column 10 (MY_KEY): '1': the keyword is there for the second time, after line 9"},
      {"OBJECT_NAME = ORBITER [A]", "", "the segment from line 7 on: there is no OBJECT_NAME"},
      {"OBJECT_ID = 1996-062A", "", "the segment from line 7 on: there is no OBJECT_ID"},
      {"CENTER_NAME = MARS BARYCENTER", "", "the segment from line 7 on: there is no CENTER_NAME"},
      {"CENTER_NAME = MARS BARYCENTER", "CENTER_NAME =", "line 11, column 14 (CENTER_NAME): '': it is empty"},
      {"REF_FRAME = EME2000", "", "the segment from line 7 on: there is no REF_FRAME"},
      {"REF_FRAME = EME2000", "REF_FRAME =", "line 12, column 12 (REF_FRAME): '': it is empty"},
      {"TIME_SYSTEM = TDB", "", "the segment from line 7 on: there is no TIME_SYSTEM"},
      {"TIME_SYSTEM = TDB", "TIME_SYSTEM = TCG",
       "line 14, column 15 (TIME_SYSTEM): 'TCG': the time systems that are read are UTC, TAI, TT, TDB and "
       "GPS"},
      {"TIME_SYSTEM = TDB", "TIME_SYSTEM = UT1",
       "line 14, column 15 (TIME_SYSTEM): 'UT1': the time systems that are read are UTC, TAI, TT, TDB and "
       "GPS"},
      {"TIME_SYSTEM = TDB", "TIME_SYSTEM = TAI",
       "line 49, column 15 (TIME_SYSTEM): 'TDB': the first segment has TAI; a message has one time system"},
      {"START_TIME = 1996-12-18T12:00:00.331", "", "the segment from line 7 on: there is no START_TIME"},
      {"START_TIME = 1996-12-18T12:00:00.331", "START_TIME = 1996-12-18",
       "line 15, column 14 (START_TIME): '1996-12-18': epoch '1996-12-18' in TDB: it is not written as "
       "2022-04-14T10:22:11.874999"},
      {"STOP_TIME = 1996-353T12:01:00.331", "STOP_TIME = 1996-367T12:01:00.331",
       "line 16, column 13 (STOP_TIME): '1996-367T12:01:00.331': epoch '1996-367T12:01:00.331' in TDB: there "
       "is no such day"},
      {"STOP_TIME = 1996-353T12:01:00.331", "STOP_TIME = 1996-352T12:01:00.331",
       "line 16, column 13 (STOP_TIME): '1996-352T12:01:00.331': it is before START_TIME, "
       "1996-12-18T12:00:00.331"},
      {"STOP_TIME = 1996-353T12:01:00.331",
       "STOP_TIME = 1996-353T12:01:00.331\nUSEABLE_STOP_TIME = 1996-354T00:00:00",
       "line 16, column 13 (STOP_TIME): '1996-353T12:01:00.331': it is before USEABLE_STOP_TIME, "
       "1996-12-19T00:00:00.000"},
      {"STOP_TIME = 1996-353T12:01:00.331", "STOP_TIME = 1996-353T12:00:30",
       "line 23, column 1 (EPOCH): '1996-353T12:01:00.331': outside START_TIME, 1996-12-18T12:00:00.331, and "
       "STOP_TIME, 1996-12-18T12:00:30.000"},
      {"INTERPOLATION_DEGREE = 3", "INTERPOLATION_DEGREE = 3.0",
       "line 18, column 24 (INTERPOLATION_DEGREE): '3.0': not a whole number"},
      {"INTERPOLATION_DEGREE = 3", "INTERPOLATION_DEGREE = 1001",
       "line 18, column 24 (INTERPOLATION_DEGREE): '1001': no degree of an interpolation, which is at most "
       "1000"},
      data("1996-12-18T12:00:00.331 2789.619 -.280045 +1746.755",
           "1: '1996-12-18T12:00:00.331 2789.619 -.280045 +1746.755 -2.49586...': 9 fields; a line of data "
           "has an epoch and 6 numbers, or 9"),
      data("1996-12-18T12:00:00.331 2789.619 -.280045 nan 4.73372", "43 (Z): 'nan': not a finite number"),
      data("1996-12-18T12:00:00.331  inf -.280045 1 4.73372", "26 (X): 'inf': not a finite number"),
      data("1996-12-18T12:00:00.331 2789,6 -.280045 1 4.73372", "25 (X): '2789,6': not a finite number"),
      data("1996-12-18T12:00:00.331 2789.6 -.280045 1 4.73D0",
           "43 (X_DOT): '4.73D0': its exponent has the letter D, where E is needed"),
      data("1996-12-18T12:00:00.331 2789.6 -.280045 1 0x1p3", "43 (X_DOT): '0x1p3': not a finite number"),
      data("1996-12-18T12:00:00.331 2789.6 -.280045 1 1e306",
           "43 (X_DOT): '1e306': in SI units too large or too small for a double, 5e-324 to 1.8e308"),
      data("1996-12-18T12:00:00.331Z 2789.6 -.280045 1 1",
           "1 (EPOCH): '1996-12-18T12:00:00.331Z': epoch '1996-12-18T12:00:00.331Z' in TDB: it is not "
           "written as 2022-04-14T10:22:11.874999"),
      {"1996-353T12:01:00.331 2783", "1996-353T12:00:00.331 2783",
       "line 23, column 1 (EPOCH): '1996-353T12:00:00.331': not later than the line before, at "
       "1996-12-18T12:00:00.331"},
      data("1996-12-18T11:59:59 2789.6 -.280045 1 1",
           "1 (EPOCH): '1996-12-18T11:59:59': outside START_TIME, 1996-12-18T12:00:00.331, and STOP_TIME, "
           "1996-12-18T12:01:00.331"),
      data("1996-12-18T12:00:00.331 1e-400 -.280045 1 1",
           "25 (X): '1e-400': in SI units too large or too small for a double, 5e-324 to 1.8e308"),
      data("1996-12-18T12:00:00.331 2789.6 1" + std::string(100, '0') + " 1 1",
           "32 (Y): '100000000000000000000000000000000000000000000000000000000000...': a number of more than "
           "100 characters"),
      data("1996-12-18T12:00:00.331 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16",
           "1: '1996-12-18T12:00:00.331 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 ...': 22 fields; a line of data "
           "has an epoch and 6 numbers, or 9"),
      data("X = 1",
           "1: 'X = 1 -2.49586 -1.04195 0.001 -.53E-6 1.5e-3': no line of data, and not META_START or "
           "COVARIANCE_START"),
      {"COMMENT between two lines", "META_STOP",
       "line 22, column 1: 'META_STOP': 1 fields; a line of data has an epoch and 6 numbers, or 9"},
      {"COVARIANCE_START\n", "",
       "line 25, column 1: 'EPOCH = 1996-12-18T12:00:00.331': no line of data, and not META_START or "
       "COVARIANCE_START"},
      {"COVARIANCE_STOP", "", "line 44, column 1: 'META_START': expected COVARIANCE_STOP"},
      {"EPOCH = 1996-12-18T12:00:00.331\n", "\n",
       "line 27, column 17 (COV_REF_FRAME): 'RTN': it must be once behind the EPOCH"},
      {"1 2 3 4\n", "1 2 3\n", "line 31, column 1: '1 2 3': 3 numbers; row 4 has 4"},
      {"-1 2 3 4 5 6e-9", "-1 2 3 4 5 -6e-9",
       "line 33, column 12 (covariance): '-6e-9': a variance that is negative"},
      {"-1 2 3 4 5 6e-9", "",
       "line 34, column 1: 'EPOCH = 1996-12-18T12:00:01': the covariance before has 5 of 6 rows"},
      {"-1 2 3 4 5 6e-9", "-1 2 3 4 5 6e-9\n7",
       "line 34, column 1: '7': a row of a covariance, of which there is no EPOCH"},
      {"EPOCH = 1996-12-18T12:00:01", "EPOCH = 1996-12-18T12:00:00",
       "line 34, column 9 (EPOCH): '1996-12-18T12:00:00': not later than the covariance before, at "
       "1996-12-18T12:00:00.331"},
      {"COV_REF_FRAME = RTN", "COV_FRAME = RTN",
       "line 27, column 13 (COV_FRAME): 'RTN': the keyword is not of a covariance"},
      // A tab is a blank between words and around them, but no part of a value: in the header as in the
      // metadata.
      {"ORIGINATOR = HERE", "ORIGINATOR =\tH\tERE\t",
       "line 4, column 15: the byte 9 is no printable character of ASCII"},
      {"OBJECT_ID = 1996-062A", "\tOBJECT_ID\t=\t1996\t062A",
       "line 10, column 18: the byte 9 is no printable character of ASCII"},
      {"COV_REF_FRAME = RTN", "COV_REF_FRAME = R\tN",
       "line 27, column 18: the byte 9 is no printable character of ASCII"},
      {"COMMENT between", "COMMENT \x01", "line 22, column 9: the byte 1 is no printable character of ASCII"},
      {"6789.5", "6789.5\xC2\xB5", "line 53, column 40: the byte 194 is no printable character of ASCII"},
      {"1996-12-18T12:00:00.123456789012 6789.5 0 1e-303 0 0 7", "",
       "the segment from line 44 on: there are no data lines"},
  };
  for (const Fault& fault : faults) {
    const std::string what = complaint_of(replaced(full, fault.old, fault.by));
    EXPECT_EQ(what, "orbit ephemeris message, " + fault.reason) << fault.old << " -> " << fault.by;
  }
}

TEST(OrbitEphemerisMessage, TheFileIsNamedAndMustBeWhole) {
  const TemporaryFile wrong(replaced(full, "+1746.755", "nan"));
  EXPECT_EQ(complaint([&] { Message::read(wrong.path()); }, wrong.path()),
            "orbit ephemeris message FILE, line 21, column 43 (Z): 'nan': not a finite number");
  const TemporaryFile cut(topo.substr(0, topo.size() - 4));
  EXPECT_EQ(complaint([&] { Message::read(cut.path()); }, cut.path()),
            "orbit ephemeris message FILE, line 22: the file stops within this line; it was truncated");
  // What stands before the end is named first, and after COVARIANCE_STOP nothing can be missing.
  const TemporaryFile cut_and_wrong(replaced(topo.substr(0, topo.size() - 4), "UTC", "TCG"));
  EXPECT_EQ(
      complaint([&] { Message::read(cut_and_wrong.path()); }, cut_and_wrong.path()),
      "orbit ephemeris message FILE, line 10, column 24 (TIME_SYSTEM): 'TCG': the time systems that are "
      "read are UTC, TAI, TT, TDB and GPS");
  const TemporaryFile whole(full.substr(0, full.find("COVARIANCE_STOP") + 15));
  EXPECT_EQ(Message::read(whole.path()).segments().size(), 1U);
  EXPECT_EQ(complaint([] { return Message::read("/no/such/file"); }),
            "orbit ephemeris message /no/such/file: cannot be read");
  EXPECT_EQ(complaint_of(""), "orbit ephemeris message: there is no message");
  EXPECT_EQ(complaint_of("CCSDS_OEM_VERS = 2.0\n"),
            "orbit ephemeris message, line 1: there is no META_START");
  std::string windows = topo;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.insert(at, "\r");
  const TemporaryFile good("\xEF\xBB\xBF" + windows);
  EXPECT_EQ(Message::read(good.path()).text(), Message::parse(topo).text());
}

TEST(OrbitEphemerisMessage, TabsBetweenWordsAreBlanks) {
  const std::string tabbed = replaced(replaced(replaced(full, "ORIGINATOR = HERE", "\tORIGINATOR\t=\tHERE\t"),
                                               "2789.619 -.280045", "\t2789.619\t-.280045"),
                                      "COMMENT between two lines", "\tCOMMENT\tbetween two lines");
  EXPECT_EQ(Message::parse(tabbed).text(), Message::parse(full).text());
}

TEST(OrbitEphemerisMessage, WhatAVersionLacks) {
  EXPECT_EQ(
      complaint_of(replaced(replaced(full, "3.0", "1.0"), "CLASSIFICATION = public, test-data\n", "")),
      "orbit ephemeris message, line 4, column 14 (MESSAGE_ID): '7': the keyword is of version 3.0, the "
      "message of version 1.0");
  const std::string plain = replaced(topo, "2.0", "1.0");
  EXPECT_NO_THROW(Message::parse(plain));
  EXPECT_EQ(complaint_of(plain + "2022-01-17T14:00:00 1 2 3 4 5 6 7 8 9\n"),
            "orbit ephemeris message, line 23, column 33 (X_DDOT): '7': version 1.0 has no acceleration");
  EXPECT_EQ(complaint_of(plain + "COVARIANCE_START\n"),
            "orbit ephemeris message, line 23, column 1: 'COVARIANCE_START': version 1.0 has no covariance");
  EXPECT_EQ(
      complaint_of(replaced(plain, "TIME_SYSTEM ", "REF_FRAME_EPOCH = 2020-01-01T00:00:00\nTIME_SYSTEM ")),
      "orbit ephemeris message, line 10, column 19 (REF_FRAME_EPOCH): '2020-01-01T00:00:00': the keyword is "
      "of "
      "version 2.0, the message of version 1.0");
  EXPECT_EQ(complaint([&] { return Message::parse(topo).segments()[0].accelerations<Eme2000, Ship>(); }),
            "orbit ephemeris message, the segment from line 5 on: the line of 2022-01-17T12:00:00.000 has no "
            "acceleration");
  auto header = Message::parse(full).header();
  header.classification = header.message_id = "";
  header.version = "1.0";
  const std::string place = "orbit ephemeris message, the segment from line ";
  const auto as_oldest = [&](const std::string& text) {
    return complaint([&] { Message(header, Message::parse(text).segments()); });
  };
  const std::string epoch = "REF_FRAME_EPOCH = 2000-001T11:58:55.816\n";
  EXPECT_EQ(as_oldest(full), place + "7 on: version 1.0 has no REF_FRAME_EPOCH, the segment has one");
  EXPECT_EQ(as_oldest(replaced(full, epoch, "")),
            place + "7 on: version 1.0 has no covariance, the segment has one");
  EXPECT_EQ(as_oldest(topo + "2022-01-17T14:00:00 1 2 3 4 5 6 7 8 9\n"),
            place + "5 on: version 1.0 has no acceleration, the segment has one");
  EXPECT_EQ(as_oldest(topo), "nothing was thrown");
}

}  // namespace
}  // namespace vectrix::orbit_ephemeris_message_test
