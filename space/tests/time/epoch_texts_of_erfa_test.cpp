#include <erfa.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>
#include <string>

#include <vectrix/space/time/epoch.hpp>

#include "temporary_file.hpp"

namespace vectrix::epoch_texts_of_erfa_test {
namespace {

// Whether TAI of the text in UTC is that of eraDtf2d and eraUtctai, to the last bit.
void expect_erfa(int year, int month, int day, int hour, int minute, double second) {
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%015.12f", year, month, day, hour, minute,
                second);
  double day_of_utc = 0.0, fraction = 0.0, tai_day = 0.0, tai = 0.0;
  ASSERT_GE(eraDtf2d("UTC", year, month, day, hour, minute, std::stod(text + 17), &day_of_utc, &fraction), 0);
  ASSERT_GE(eraUtctai(day_of_utc, fraction, &tai_day, &tai), 0);
  const Epoch epoch = Epoch::from_utc(text);
  // ERFA's fraction may exceed a day, of which the difference is exact.
  EXPECT_EQ((epoch.tai().day - tai_day) + epoch.tai().fraction, tai) << text;
}

TEST(EpochTexts, AreThoseOfErfaToTheLastBit) {
  std::mt19937_64 random(20261129);
  const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  for (int i = 0; i < 20000; ++i) {
    const double second = below(2) ? below(60) : std::uniform_real_distribution(0.0, 59.9)(random);
    expect_erfa(1960 + below(80), 1 + below(12), 1 + below(28), below(24), below(60), second);
  }
  // The days of the steps before 1972 and of leap seconds, to their last second.
  for (const auto& [year, month, day] : {std::array{1961, 7, 31},
                                         {1963, 10, 31},
                                         {1968, 1, 31},
                                         {1971, 12, 31},
                                         {1972, 6, 30},
                                         {1998, 12, 31},
                                         {2015, 6, 30},
                                         {2016, 12, 31}}) {
    for (int i = 0; i < 100; ++i) expect_erfa(year, month, day, below(24), below(60), below(60));
    for (const double second : {0.0, 58.5, 59.0, 59.8}) expect_erfa(year, month, day, 23, 59, second);
    if (year >= 1972) {
      for (const double second : {60.0, 60.5, 60.999999}) expect_erfa(year, month, day, 23, 59, second);
    }
  }
}

TEST(EpochTexts, EndWhereADayOfUtcEnds) {
  const auto fault = [](const TimeScale& scale, const std::string& text) {
    const std::string place = "epoch '" + text + "' in " + scale.name() + ": ";
    const std::string said = complaint([&] { return Epoch::from(scale, text); });
    return said.starts_with(place) ? said.substr(place.size()) : said;
  };
  const std::string none = "nothing was thrown", no_second = "there is no such second";
  EXPECT_EQ(fault(scale::utc, "2016-12-31T23:59:60.999999999999"), none);
  for (const char* text :
       {"2016-12-31T23:59:61", "2016-12-31T22:59:60", "2016-12-31T23:58:60", "2016-12-30T23:59:60"})
    EXPECT_EQ(fault(scale::utc, text), no_second) << text;
  // 0.05 s were left out at the end of 1961 July, and 0.1 s put in at that of 1963 October.
  EXPECT_EQ(fault(scale::utc, "1961-07-31T23:59:59.949"), none);
  EXPECT_EQ(fault(scale::utc, "1961-07-31T23:59:59.951"), no_second);
  EXPECT_EQ(fault(scale::utc, "1963-10-31T23:59:60.099"), none);
  EXPECT_EQ(fault(scale::utc, "1963-10-31T23:59:60.101"), no_second);
  for (const TimeScale& scale :
       {TimeScale{scale::tai}, TimeScale{scale::tt}, TimeScale{scale::tdb}, TimeScale{scale::gps}})
    EXPECT_EQ(fault(scale, "2016-12-31T23:59:60"), no_second);
}

}  // namespace
}  // namespace vectrix::epoch_texts_of_erfa_test
