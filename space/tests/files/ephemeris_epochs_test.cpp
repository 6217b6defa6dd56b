#include <string>
#include <vector>

#include "files/orbit_ephemeris_texts.hpp"

// The epochs of a message at the ends of the scales, and around a leap second.
namespace vectrix::orbit_ephemeris_message_test {
namespace {

std::string message_of(const std::string& system, const std::string& time) {
  return "CCSDS_OEM_VERS = 2.0\nCREATION_DATE =\nORIGINATOR =\nMETA_START\nOBJECT_NAME =\nOBJECT_ID =\n"
         "CENTER_NAME = EARTH\nREF_FRAME = GCRF\nTIME_SYSTEM = " +
         system + "\nSTART_TIME = " + time + "\nSTOP_TIME = " + time + "\nMETA_STOP\n" + time +
         " 7000 0 0 0 7 0\n";
}
Epoch time_of(const std::string& text) {
  return Message::parse(text).segments()[0].samples<Gcrf, Ship>()[0].time;
}

TEST(EphemerisEpochs, ReadBackAsTheSameFromTheFirstToTheLast) {
  struct Case {
    const TimeScale* scale;
    std::vector<std::string> begins;  // of a minute
  };
  const std::string day_0 = "0000-01-01T00:00", day_9999 = "9999-12-31T23:59";
  const Case cases[] = {{&scale::utc, {"1960-01-01T00:00", "1971-12-31T23:59", "2016-12-31T23:59", day_9999}},
                        {&scale::gps, {"1980-01-06T00:00", day_9999}},
                        {&scale::tai, {day_0, day_9999}},
                        {&scale::tt, {day_0, day_9999}},
                        {&scale::tdb, {day_0, day_9999}}};
  for (const auto& [scale, begins] : cases) {
    for (const std::string& begin : begins) {
      std::vector<std::string> seconds{"00",
                                       "00.000000000001",
                                       "00.0000000001",
                                       "00.000000000499",
                                       "00.0000000005",
                                       "00.000000000999",
                                       "59.9994",
                                       "59.9995",
                                       "59.9999999994",
                                       "59.9999999996",
                                       "59.999999999999"};
      if (begin == "2016-12-31T23:59")
        seconds.insert(seconds.end(), {"60", "60.0000000001", "60.999999999999"});
      for (const std::string& second : seconds) {
        const std::string time = begin + ":" + second;
        const std::string written = Message::parse(message_of(scale->name(), time)).text();
        EXPECT_EQ(time_of(written), Epoch::from(*scale, time)) << scale->name() << " " << time << written;
      }
    }
  }
}

// The reader keeps the day of the line before: over midnight, a leap second, and both ways to write a day.
TEST(EphemerisEpochs, OfManyDaysAreThoseOfEachText) {
  const std::vector<std::string> times{
      "2016-12-30T00:00:00",      "2016-365T12:00:00.5", "2016-12-30T23:59:59.999999999999",
      "2016-12-31T23:59:59.5",    "2016-366T23:59:60",   "2016-12-31T23:59:60.5",
      "2016-12-31T23:59:60.999Z", "2017-01-01T00:00:00", "2017-001T00:00:00.001Z",
      "2017-01-01T00:00:01",      "2017-01-11T23:59:59", "2017-02-01T00:00:00",
      "2017-032T00:00:01"};
  std::string text = replaced(message_of("UTC", times.front()), "STOP_TIME = 2016-12-30T00:00:00",
                              "STOP_TIME = 2018-01-01T00:00:00");
  for (std::size_t i = 1; i < times.size(); ++i) text += times[i] + " 7000 0 0 0 7 0\n";
  const auto samples = Message::parse(text).segments()[0].samples<Gcrf, Ship>();
  ASSERT_EQ(samples.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_EQ(samples[i].time, Epoch::from_utc(times[i])) << times[i];
  for (const char* wrong :
       {"2017-032T23:59:60", "2017-02-29T00:00:00", "2017-366T00:00:00", "2017-00-00T00:00:00"}) {
    EXPECT_EQ(complaint_of(text + wrong + " 7000 0 0 0 7 0\n"),
              "orbit ephemeris message, line 26, column 1 (EPOCH): '" + std::string{wrong} +
                  "': " + complaint([&] { return Epoch::from_utc(wrong); }));
  }
}

TEST(EphemerisEpochs, WithoutATextAreRefusedWithTheSamples) {
  const auto at = [](const TimeScale& system, const Epoch& time) {
    EphemerisMetadata metadata{"SHIP", "2026-001A"};
    metadata.time_system = system;
    const std::vector<PositionSample<Gcrf, Ship, Epoch>> one{
        {time, Message::parse(message_of("TT", "2020-01-01T00:00:00"))
                   .segments()[0]
                   .samples<Gcrf, Ship>()[0]
                   .motion}};
    return complaint([&] { Segment(metadata, one); });
  };
  const std::string place = "orbit ephemeris segment of 'SHIP': ";
  EXPECT_EQ(at(scale::utc, Epoch::from_tt("1959-01-01T00:00:00")),
            place + "Epoch 1958-12-31T23:59:27.816000 TAI: UTC is not known before 1960");
  EXPECT_EQ(at(scale::gps, Epoch::from_tt("1979-01-01T00:00:32.184")),
            place + "Epoch 1979-01-01T00:00:00.000000 TAI: GPS time begins in 1980");
  EXPECT_EQ(at(scale::tai, Epoch::from_julian_date(scale::tai, 5373483.5) + 2.0 * 86400.0 * si::second),
            place + "the epoch 10000-01-02T00:00:00.000000000 TAI is not of the years 0 to 9999");
  EXPECT_EQ(at(scale::tai, Epoch::from_julian_date(scale::tai, 5373484.5, -1e-5)), "nothing was thrown");
}

}  // namespace
}  // namespace vectrix::orbit_ephemeris_message_test
