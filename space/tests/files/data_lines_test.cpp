#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include <vectrix/space/files/orbit_ephemeris_message.hpp>

#include "temporary_file.hpp"
#include "testing/trials.hpp"

namespace vectrix::data_lines_test {
namespace {

struct Place : moving_frame {};
using earth::Gcrf;

// A line on the day of the one before is read in one pass, any other one word by word.

std::string message_of(const TimeScale& scale, const std::vector<std::string>& lines) {
  std::string text =
      "CCSDS_OEM_VERS = 2.0\nCREATION_DATE =\nORIGINATOR =\nMETA_START\nOBJECT_NAME =\nOBJECT_ID =\n"
      "CENTER_NAME = EARTH\nREF_FRAME = GCRF\nTIME_SYSTEM = " +
      std::string{scale.name()} +
      "\nSTART_TIME = " + (scale.kind() == TimeScale::Kind::gps ? "1980" : "1960") +
      "-01-06T00:00:00\nSTOP_TIME = 2060-01-01T00:00:00\nMETA_STOP\n";
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

const std::string numbers = " 1 2 3 4 5 6";

void expect_times(const TimeScale& scale, const std::vector<std::string>& times) {
  std::vector<std::string> lines;
  for (const std::string& time : times) lines.push_back(time + numbers);
  const auto message = OrbitEphemerisMessage::parse(message_of(scale, lines));
  const auto samples = message.segments().front().samples<Gcrf, Place>();
  ASSERT_EQ(samples.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    ASSERT_EQ(samples[i].time, Epoch::from(scale, times[i])) << scale.name() << " " << times[i];
}

const std::vector<TimeScale> scales{scale::utc, scale::tai, scale::tt, scale::tdb, scale::gps};

TEST(DataLines, HaveTheTimesOfTheirTexts) {
  std::mt19937_64 random(20261129);
  const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  for (const TimeScale& scale : scales) {
    for (const double longest : {3.0, 40000.0}) {  // s: many lines of a day, or few
      Epoch time = Epoch::from(scale, scale.kind() == TimeScale::Kind::gps ? "1980-01-06T00:00:00"
                                                                           : "1961-07-25T00:00:00") +
                   1e8 * below(10) * si::second;
      std::vector<std::string> times;
      for (int i = 0; i < vectrix_test::trials(1000); ++i) {
        time = time + std::uniform_real_distribution(1.1, longest)(random) * si::second;
        const int decimals = below(13);
        std::string text = below(2) ? time.text(scale, std::min(decimals, 9))
                                    : time.day_of_year_text(scale, std::min(decimals, 9));
        for (int more = 9; more < decimals; ++more) text += static_cast<char>('0' + below(10));
        if (scale.kind() == TimeScale::Kind::utc && below(4) == 0) text += 'Z';
        times.push_back(text);
      }
      expect_times(scale, times);
    }
  }
}

TEST(DataLines, HaveTheTimesOfTheEndsOfDays) {
  expect_times(scale::utc, {"1961-07-31T23:59:59.9", "1961-08-01T00:00:00", "1963-10-31T23:59:59",
                            "1963-10-31T23:59:60.05", "1963-11-01T00:00:00.000000000001",
                            "2016-12-31T23:59:59.9999999999", "2016-12-31T23:59:60", "2016-366T23:59:60.5",
                            "2016-12-31T23:59:60.9999999999Z", "2017-01-01T00:00:00", "2017-001T00:00:00.1",
                            "2017-001T00:00:00.2"});
  for (const TimeScale& scale : scales)
    expect_times(scale, {"1999-12-31T00:00:00", "1999-12-31T23:59:59.999999999", "2000-01-01T00:00:00",
                         "2000-01-01T00:00:00.000000001", "2000-060T12:00:00", "2000-02-29T12:00:01",
                         "2000-03-01T00:00:00"});
}

// What is read of a line and what is said of it do not depend on the line before.
TEST(DataLines, AreReadAsTheFirstOne) {
  const std::string first = "2016-12-31T00:00:00" + numbers;
  const auto said = [](const TimeScale& scale, const std::vector<std::string>& lines) {
    std::string text = complaint([&] {
      const auto message = OrbitEphemerisMessage::parse(message_of(scale, lines));
      std::string all;
      for (const auto& line : message.segments().front().lines(detail::trusted).lines) {
        if (&line != &message.segments().front().lines(detail::trusted).lines.back()) continue;
        for (const double x : {line.time.tai().day, line.time.tai().fraction, line.position.x(),
                               line.velocity.z(), line.acceleration ? line.acceleration->z() : 7.0})
          all += detail::text(x) + " ";
      }
      throw BadInput(all);
    });
    const auto line = text.find(", line ");
    return line == std::string::npos ? text : text.substr(text.find(',', line + 1));
  };
  const std::string time = "2016-12-31T11:22:33.25";
  std::vector<std::string> lines{time + numbers,
                                 time + " 1 2 3 4 5 6 7 8 9",
                                 time + "Z" + numbers,
                                 time + "\t1  2 \t3 4 5 6 \t",
                                 time + " 1 2 3 4 5",
                                 time + " 1 2 3 4 5 6 7",
                                 time + " 1 2 3 4 5 6 7 8 9 10",
                                 time + " 1 2 3 4 5 6e400",
                                 time + " nan 2 3 4 5 6",
                                 time + " 1 2 3 4 5 0x6",
                                 time + " 1 2 3 4 5 6,",
                                 time + ",1 2 3 4 5 6",
                                 time + " A = 1",
                                 time + " 1 2 3 4 5 6e",
                                 time + " 1 2 3 4 5 6e+",
                                 time + " 1 2 3 4 5 +-6",
                                 time + " 1e-300 2 3 4 5 12345678901234567890.5",
                                 time + " 4.9e-324 2 3 4 5 9007199254740993",
                                 time + " 1 2 3 4 5 6e-00000000000000001",
                                 time + numbers + "\x01",
                                 time + numbers + "\xC3\xA9",
                                 time,
                                 time + "1 2 3 4 5 6",
                                 "2016-12-31T24:00:00" + numbers,
                                 "2016-12-31T11:60:00" + numbers,
                                 "2016-12-31T11:22:60" + numbers,
                                 "2016-12-31T23:59:60" + numbers,
                                 "2016-12-31T23:59:61" + numbers,
                                 "2016-12-31T11:22:33." + numbers,
                                 "2016-12-31T11:22:33.1234567890123" + numbers,
                                 "2016-12-31 11:22:33" + numbers,
                                 "2016-12-31T1:22:33" + numbers,
                                 "2016-12-31T11:22:3" + numbers,
                                 "2016-12-31T" + numbers,
                                 "2016-12-31" + numbers,
                                 "2061-12-31T00:00:00" + numbers};
  std::mt19937_64 random(20261129);
  const std::string alphabet = "0123456789 .+-eETZ:=\tD";
  for (int i = 0; i < 3000; ++i) {
    std::string line = time + " -1.5 +2e-3 .3 4. 5E+02 6";
    for (std::size_t change = 0; change < 1 + random() % 2; ++change)
      line[11 + random() % (line.size() - 11)] = alphabet[random() % alphabet.size()];
    lines.push_back(line);
  }
  for (const TimeScale& scale : {TimeScale{scale::utc}, TimeScale{scale::gps}}) {
    for (const std::string& line : lines) ASSERT_EQ(said(scale, {first, line}), said(scale, {line})) << line;
  }
  EXPECT_EQ(
      complaint([&] {
        OrbitEphemerisMessage::parse(message_of(scale::utc, {first, first}));
      }),
      "orbit ephemeris message, line 14, column 1 (EPOCH): '2016-12-31T00:00:00': not later than the line "
      "before, at 2016-12-31T00:00:00.000");
}

}  // namespace
}  // namespace vectrix::data_lines_test
