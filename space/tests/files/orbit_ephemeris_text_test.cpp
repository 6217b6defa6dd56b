#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "files/orbit_ephemeris_texts.hpp"

namespace vectrix::orbit_ephemeris_message_test {
namespace {

TEST(OrbitEphemerisMessage, ATextOfAMessageIsTheMessage) {
  for (const std::string& text : {topo, stk, full}) {
    const auto message = Message::parse(text);
    const std::string written = message.text();
    EXPECT_EQ(Message::parse(written).text(), written);
    const TemporaryFile file("");
    message.write(file.path());
    EXPECT_EQ(Message::read(file.path()).text(), written);
  }
  // Where the text has its place, so that nothing is left out.
  const std::string written = Message::parse(full).text();
  for (const char* part :
       {"CLASSIFICATION = public, test-data\n", "MESSAGE_ID = 7\n", "COMMENT   first\n",
        "OBJECT_NAME = ORBITER [A]\n", "REF_FRAME_EPOCH = 2000-01-01T11:58:55.816\n",
        "STOP_TIME = 1996-12-18T12:01:00.331\n", "INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 3\n",
        "COMMENT between two lines\n",
        "1996-12-18T12:00:00.331 2.789619e+03 -2.80045e-01 1.746755e+03 4.73372e+00 -2.49586e+00 "
        "-1.04195e+00 "
        "1.0e-03 -5.3e-07 1.5e-03\n",
        "COV_REF_FRAME = RTN\n1.0e-04\n", "-1.0e+00 2.0e+00 3.0e+00 4.0e+00 5.0e+00 6.0e-09\n",
        "OBJECT_NAME =\n", "1996-12-18T12:00:00.1234567890", " 6.7895e+03 0.0e+00 1.0e-303 "})
    EXPECT_NE(written.find(part), std::string::npos) << part << written;
  EXPECT_EQ(complaint([] { Message::parse(topo).write("/no/such/folder/file"); }),
            "orbit ephemeris message /no/such/folder/file: cannot be written");
}

// Samples of every size, written and read: the same to the last bit.
TEST(OrbitEphemerisMessage, SamplesReadBackToTheLastBit) {
  std::mt19937_64 random(20261129);
  const auto number = [&] {
    const double mantissa = std::uniform_real_distribution<double>(-10.0, 10.0)(random);
    return mantissa *
           std::pow(10.0, std::uniform_int_distribution<int>(-320, 300)(random) / (random() % 3 ? 30 : 1));
  };
  for (int run = 0; run < 200; ++run) {
    std::vector<PositionSample<Gcrf, Ship, Epoch>> samples;
    Epoch time = Epoch::from_utc("2016-12-31T23:59:5" + std::to_string(run % 10));
    for (int i = 0; i < 10; ++i) {
      const auto vector = [&] { return Eigen::Vector3d(number(), number(), number()); };
      // Epochs as a text gives them: any other is rounded to the text, 1e-11 s.
      const auto& system = run % 2 == 0 ? static_cast<const TimeScale&>(scale::utc) : scale::tt;
      time = Epoch::from(system, (time + 1.0 * si::second).text(system, 9) +
                                     (run % 4 < 2 ? std::to_string(100 + random() % 900) : ""));
      samples.push_back({time, point_motion(of<Ship>, relative_to<Gcrf>, observed_from<Gcrf>,
                                            vectrix::vector<si::length>(in<Gcrf>, vector()),
                                            vectrix::vector<si::velocity>(in<Gcrf>, vector()))});
    }
    EphemerisMetadata metadata{"SHIP", "2026-001A"};
    metadata.time_system = run % 2 == 0 ? static_cast<const TimeScale&>(scale::utc) : scale::tt;
    metadata.interpolation = "HERMITE";
    metadata.interpolation_degree = 7;
    const Message message({"2.0", "2026-11-29T00:00:00", "HERE"}, {Segment(metadata, samples)});
    const auto again = Message::parse(message.text()).segments()[0].samples<Gcrf, Ship>();
    ASSERT_EQ(again.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      EXPECT_EQ(again[i].time, samples[i].time) << message.text();
      EXPECT_EQ(position(again[i]), position(samples[i]));
      EXPECT_EQ(again[i].motion.velocity.coordinates(), samples[i].motion.velocity.coordinates());
    }
  }
}

// Numbers of few and of many digits, with an exponent or without one: the double next to the written metres.
TEST(OrbitEphemerisMessage, KilometresBecomeMetresRoundedOnce) {
  std::mt19937_64 random(20261129);
  const auto x_of = [](const std::string& number) {
    const auto message = Message::parse(replaced(topo, "545.284043961596", number));
    return message.segments()[0].samples<Eme2000, Ship>()[0].motion.position.coordinates().x();
  };
  for (int run = 0; run < 5000; ++run) {
    std::string number = random() % 2 ? "-" : random() % 2 ? "+" : "";
    const std::size_t digits = 1 + random() % 22, point = random() % (digits + 2);
    for (std::size_t i = 0; i < digits; ++i) {
      if (i == point) number += '.';
      number += static_cast<char>('0' + random() % 10);
    }
    if (point == digits) number += '.';
    const int exponent = run % 2 ? 0 : static_cast<int>(random() % 30) - 15;
    const std::string metres =
        (number[0] == '+' ? number.substr(1) : number) + "e" + std::to_string(3 + exponent);
    if (run % 2 == 0) number += (random() % 2 ? "e" : "E") + std::to_string(exponent);
    double expected = 0.0;
    ASSERT_EQ(std::from_chars(metres.data(), metres.data() + metres.size(), expected).ec, std::errc{})
        << metres;
    const double x = x_of(number);
    EXPECT_EQ(x, expected) << number;
    EXPECT_EQ(std::signbit(x), std::signbit(expected)) << number;
  }
  // Metres in the middle of two doubles, which go to the even one, and a micrometre beside it.
  for (int run = 0; run < 200; ++run) {
    const std::uint64_t middle = (std::uint64_t{1} << 53) + (random() >> 12) * 2 + 1;
    const std::string metres = std::to_string(middle);
    const std::string km = metres.substr(0, metres.size() - 3) + "." + metres.substr(metres.size() - 3);
    EXPECT_EQ(x_of(km), static_cast<double>(middle)) << km;
    EXPECT_EQ(x_of(km + "001"), static_cast<double>(middle + 1)) << km;
  }
  for (const char* wrong : {".", "-", "-.", "1.2.3", "1-", "--1", "1..2"})
    EXPECT_EQ(
        complaint_of(replaced(topo, "545.284043961596", wrong)),
        "orbit ephemeris message, line 21, column 25 (X): '" + std::string{wrong} + "': not a finite number");
}

TEST(OrbitEphemerisMessage, SegmentsOfSamples) {
  const auto samples = Message::parse(topo).segments()[0].samples<Eme2000, Ship>();
  const EphemerisMetadata metadata{"SHIP", "2026-001A"};
  const Segment segment(metadata, samples);
  EXPECT_EQ(segment.ref_frame(), "EME2000");
  EXPECT_EQ(segment.metadata().center_name, "EARTH");
  EXPECT_EQ(segment.metadata().start_time, samples[0].time);
  EXPECT_EQ(segment.metadata().stop_time, samples[1].time);
  const auto with = [&](auto change) {
    EphemerisMetadata changed = metadata;
    change(changed);
    return complaint([&] { Segment(changed, samples); });
  };
  const std::string place = "orbit ephemeris segment of 'SHIP': ";
  EXPECT_EQ(with([](auto& m) { m.object_id = "A\nB"; }),
            place + "OBJECT_ID 'A\nB' is not one line of printable ASCII without blanks around it");
  EXPECT_EQ(with([](auto& m) { m.object_id = "A\tB"; }),
            place + "OBJECT_ID 'A\tB' is not one line of printable ASCII without blanks around it");
  EXPECT_EQ(with([](auto& m) { m.object_id = " A"; }),
            place + "OBJECT_ID ' A' is not one line of printable ASCII without blanks around it");
  for (const int degree : {-1, 1001})
    EXPECT_EQ(with([&](auto& m) { m.interpolation_degree = degree; }),
              place + "INTERPOLATION_DEGREE is " + std::to_string(degree) + "; it is 0 to 1000");
  for (const int degree : {0, 1000})
    EXPECT_EQ(with([&](auto& m) { m.interpolation_degree = degree; }), "nothing was thrown");
  EXPECT_EQ(with([](auto& m) { m.comments = {"A\nB"}; }),
            place + "the comment 'A\nB' is not one line of text");
  const auto with_other = [&](const std::string& keyword, const std::string& value) {
    return with([&](auto& m) { m.others = {{"FIRST", "1"}, {keyword, value}}; });
  };
  EXPECT_EQ(with_other("SECOND", "2"), "nothing was thrown");
  EXPECT_EQ(with_other("second", "2"),
            place + "'second' among the other keywords: a keyword is of A-Z, 0-9 and _");
  EXPECT_EQ(with_other("FIRST", "2"), place + "'FIRST' among the other keywords: it is there twice");
  EXPECT_EQ(
      with_other("STOP_TIM", "2"),
      place +
          "'STOP_TIM' among the other keywords: the keyword is not of the standard, but nearly STOP_TIME");
  EXPECT_EQ(
      with_other("COMMENT", "2"),
      place + "'COMMENT' among the other keywords: the keyword has its place in another part of the message");
  EXPECT_EQ(with_other("SECOND", "2 "),
            place + "SECOND '2 ' is not one line of printable ASCII without blanks around it");
  EXPECT_EQ(with([](auto& m) { m.center_name = "MARS"; }),
            place + "CENTER_NAME is 'MARS'; the centre of 'EME2000' (earth::Eme2000) is 'EARTH'");
  EXPECT_EQ(with([&](auto& m) { m.start_time = samples[1].time; }),
            place +
                "the sample at 2022-01-17T12:00:00.000 is outside START_TIME, 2022-01-17T13:00:00.000, and "
                "STOP_TIME, 2022-01-17T13:00:00.000");
  EXPECT_EQ(with([&](auto& m) { m.useable_stop_time = Epoch::from_utc("2022-01-17T13:00:01"); }),
            place + "STOP_TIME is before USEABLE_STOP_TIME, 2022-01-17T13:00:01.000");
  EXPECT_EQ(with([](auto& m) { m.time_system = scale::Ut1::minus_tai(-37.0 * si::second); }),
            place + "TIME_SYSTEM is UT1; a message has UTC, TAI, TT, TDB or GPS");
  EXPECT_EQ(complaint([&] { Segment(metadata, std::vector<PositionSample<Eme2000, Ship, Epoch>>{}); }),
            place + "there are no samples");
  EXPECT_EQ(complaint([&] {
              Segment(metadata, std::vector{samples[1], samples[0]});
            }),
            place +
                "sample 1, at 2022-01-17T12:00:00.000, is not later than the one before, at "
                "2022-01-17T13:00:00.000");
  EXPECT_EQ(complaint([&] {
              Segment(metadata, std::vector{samples[0], samples[0]});
            }),
            place +
                "sample 1, at 2022-01-17T12:00:00.000, is not later than the one before, at "
                "2022-01-17T12:00:00.000");
  auto infinite = samples;
  infinite[1].motion.velocity =
      decltype(infinite[1].motion.velocity){detail::trusted, Eigen::Vector3d(0, HUGE_VAL, 0)};  // as of a sum
  EXPECT_EQ(complaint([&] { Segment(metadata, infinite); }), place + "sample 1 has the number inf");
  EXPECT_EQ(complaint([&] {
              Message({"2.1", "", ""}, {segment});
            }),
            "orbit ephemeris message: the version is '2.1'; the versions are 1.0, 2.0, 3.0");
  EXPECT_EQ(complaint([&] {
              Message({"2.0", "", ""}, {});
            }),
            "orbit ephemeris message: there are no segments");
  EXPECT_EQ(complaint([&] {
              Message({"2.0", "", "H\tERE"}, {segment});
            }),
            "orbit ephemeris message: ORIGINATOR 'H\tERE' is not one line of printable ASCII without blanks "
            "around it");
  EphemerisMetadata in_tai = metadata;
  in_tai.time_system = scale::tai;
  EXPECT_EQ(complaint([&] {
              Message({"2.0", "", ""}, {segment, Segment(in_tai, samples)});
            }),
            place + "the time system is TAI; the first segment has UTC; a message has one time system");
}

}  // namespace
}  // namespace vectrix::orbit_ephemeris_message_test
