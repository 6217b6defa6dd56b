#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>

#include "temporary_file.hpp"

namespace vectrix::epoch_test {
namespace {

// The fraction of a day is stored to 1e-16 day: 1e-11 s, in each of the two epochs of a difference.
constexpr double clock_rounding = 3e-11;  // s

double seconds(const Quantity<si::time>& t) {
  return t.value();
}

TEST(Epoch, ReadsAndWritesUtc) {
  EXPECT_EQ(Epoch::from_utc("2022-04-14T10:22:11.874999").utc(), "2022-04-14T10:22:11.874999");
  EXPECT_EQ(Epoch::from_utc("2022-04-14T10:22:11Z").utc(0), "2022-04-14T10:22:11");
  EXPECT_EQ(Epoch::from_utc("2022-04-14T10:22:11 UTC").utc(0), "2022-04-14T10:22:11");
  EXPECT_EQ(Epoch::from_utc("2022-04-14T23:59:59.9999996").utc(), "2022-04-15T00:00:00.000000");
  EXPECT_EQ(Epoch::from_utc("1960-01-01T00:00:00").utc(3), "1960-01-01T00:00:00.000");
  EXPECT_EQ(Epoch::from_utc("2016-12-31T23:59:60.25").utc(2), "2016-12-31T23:59:60.25");
}

// A year has four digits in a text that is read.
TEST(Epoch, RoundsToATextThatIsReadUpToTheYear9999) {
  for (const TimeScale& scale : {TimeScale{scale::utc}, TimeScale{scale::tai}, TimeScale{scale::tdb}}) {
    const Epoch end = Epoch::from(scale, "9999-12-31T23:59:59.9999999999");
    EXPECT_EQ(end.text(scale, 0), "9999-12-31T23:59:59");
    EXPECT_EQ(end.text(scale, 3), "9999-12-31T23:59:59.999");
    EXPECT_EQ(end.day_of_year_text(scale, 9), "9999-365T23:59:59.999999999");
    for (int decimals = 0; decimals <= 9; ++decimals)
      EXPECT_LT(Epoch::from(scale, end.text(scale, decimals)), end) << decimals;
    EXPECT_EQ(Epoch::from(scale, "9999-12-30T23:59:59.9999").text(scale, 3), "9999-12-31T00:00:00.000");
    EXPECT_EQ((end + 0.2e-9 * si::second).text(scale, 3), "10000-01-01T00:00:00.000");
  }
}

TEST(Epoch, KnowsTheScales) {
  const auto epoch = Epoch::from_utc("2022-04-14T10:22:11.5");
  EXPECT_EQ(seconds(epoch.tai_minus_utc()), 37.0);
  EXPECT_EQ(epoch.tt(), "2022-04-14T10:23:20.684000");
  EXPECT_NEAR(seconds(Epoch::from_tt("2022-04-14T10:23:20.684") - epoch), 0.0, clock_rounding);
  // J2000.0
  const auto j2000 = Epoch::from_tt("2000-01-01T12:00:00");
  EXPECT_EQ(j2000.utc(3), "2000-01-01T11:58:55.816");
  EXPECT_EQ(j2000.tt_date().day, 2451544.5);
  EXPECT_NEAR(j2000.tt_date().fraction, 0.5, 1e-15);
}

TEST(Epoch, CountsLeapSeconds) {
  const auto before = Epoch::from_utc("2016-12-31T00:00:00");
  const auto after = Epoch::from_utc("2017-01-01T00:00:00");
  EXPECT_NEAR(seconds(after - before), 86401.0, clock_rounding);
  EXPECT_EQ(seconds(before.tai_minus_utc()), 36.0);
  EXPECT_EQ(seconds(after.tai_minus_utc()), 37.0);
  EXPECT_EQ((before + 86400.5 * si::second).utc(1), "2016-12-31T23:59:60.5");
  EXPECT_EQ((after - 1.0 * si::second).utc(0), "2016-12-31T23:59:60");
}

TEST(Epoch, IsMadeFromAModifiedJulianDay) {
  EXPECT_EQ(Epoch::from_utc_mjd(59683).utc(0), "2022-04-14T00:00:00");
  EXPECT_EQ(Epoch::from_utc_mjd(59683, 0.75).utc(0), "2022-04-14T18:00:00");
  // The day has 86401 s.
  EXPECT_NEAR(seconds(Epoch::from_utc_mjd(57753, 0.5) - Epoch::from_utc_mjd(57753)), 43200.5, clock_rounding);
  EXPECT_THROW(Epoch::from_utc_mjd(59683, 1.0), BadInput);
  EXPECT_THROW(Epoch::from_utc_mjd(59683, std::numeric_limits<double>::quiet_NaN()), BadInput);
  EXPECT_EQ(complaint([] { Epoch::from_utc_mjd(36933); }),
            "Epoch::from_utc_mjd(36933, 0): UTC is not known before 1960");
}

TEST(Epoch, IsOrdered) {
  const auto epoch = Epoch::from_utc("2022-04-14T23:59:59");
  EXPECT_LT(epoch, epoch + 2.0 * si::second);
  EXPECT_GT(epoch, epoch - 1e-6 * si::second);
  EXPECT_EQ(epoch, epoch + 0.0 * si::second);
}

RC_GTEST_PROP(Epoch, DifferenceUndoesSum, ()) {
  const auto start =
      Epoch::from_utc_mjd(*rc::gen::inRange(41317, 61000), *rc::gen::inRange(0, 1000) / 1000.0);
  // Eleven days, or sixty years.
  const double duration = *rc::gen::inRange(-1'000'000'000, 1'000'000'000) / *rc::gen::element(1024.0, 0.5);
  const auto end = start + duration * si::second;
  RC_ASSERT(end.tai().fraction >= 0.0 && end.tai().fraction < 1.0);
  const double whole_days = 1e-16 * std::abs(duration);  // rounding of the sum of days and fraction
  RC_ASSERT(std::abs(seconds(end - start) - duration) <= clock_rounding + whole_days);
  RC_ASSERT((end > start) == (duration > 0.0) && (end == start) == (duration == 0.0));
}

RC_GTEST_PROP(Epoch, TextIsReadBack, ()) {
  const auto epoch = Epoch::from_utc_mjd(*rc::gen::inRange(41317, 61000)) +
                     (*rc::gen::inRange(0, 864'000'000) * 1e-4) * si::second;
  RC_ASSERT(std::abs(seconds(Epoch::from_utc(epoch.utc(4)) - epoch)) <= clock_rounding);
  RC_ASSERT(std::abs(seconds(Epoch::from_tt(epoch.tt(4)) - epoch)) <= clock_rounding);
}

// Until 1972 some days end in a step of 0.05 or 0.1 s, and one in 0.107758 s.
TEST(Epoch, TextOfEveryDayFrom1960IsReadBack) {
  constexpr int first = 36934, after = 41683;  // to the leap seconds of 1972, inclusive
  for (int day = first; day < after; ++day) {
    const std::string date = Epoch::from_utc_mjd(day).utc(0).substr(0, 11);
    for (const std::string time : {"00:00:00.000000", "00:00:00.000001", "12:00:00.000000", "17:43:21.123456",
                                   "23:59:00.000000", "23:59:59.800000"}) {
      EXPECT_EQ(Epoch::from_utc(date + time).utc(6), date + time);
    }
  }
}

TEST(Epoch, PrintsTheEndOfADayWithAStep) {
  EXPECT_EQ(Epoch::from_utc("1971-12-31T12:00:00").utc(6), "1971-12-31T12:00:00.000000");
  EXPECT_EQ(Epoch::from_utc("1965-08-31T12:00:00").utc(6), "1965-08-31T12:00:00.000000");
  EXPECT_EQ(Epoch::from_utc("1971-12-31T23:59:60.1").utc(6), "1971-12-31T23:59:60.100000");
  EXPECT_EQ(Epoch::from_utc("1971-12-31T23:59:60.1").utc(1), "1971-12-31T23:59:60.1");
  EXPECT_EQ(Epoch::from_utc("1971-12-31T23:59:60.1").utc(0), "1971-12-31T23:59:60");
  EXPECT_EQ(Epoch::from_utc("1961-07-31T23:59:59.9").utc(0), "1961-08-01T00:00:00");  // it ends at 59.95
  EXPECT_EQ(Epoch::from_utc("2016-12-31T23:59:60.75").utc(2), "2016-12-31T23:59:60.75");
  EXPECT_EQ(Epoch::from_utc("2016-12-31T23:59:60.75").utc(0), "2017-01-01T00:00:00");
  EXPECT_EQ(Epoch::from_utc("2016-12-31T23:59:59.75").utc(0), "2016-12-31T23:59:60");
}

std::string refusal(const std::string& text) {
  return complaint([&] { Epoch::from_utc(text); });
}

TEST(Epoch, RefusesBadText) {
  for (const std::string text : {"",
                                 "yesterday",
                                 "2022-04-14",
                                 "2022-04-14 10:22:11",
                                 "2022-04-14T10:22",
                                 "2022-4-14T10:22:11",
                                 "2022-04-14T10:22:11.",
                                 "2022-04-14T10:22:11,5",
                                 "2022-04-14T10:22:11+02:00",
                                 "2022-04-14T10:22:11 TAI",
                                 "2022-04-14T10:22:11UTC",
                                 "2022-04-14T10:22:11Z UTC",
                                 "2022-04-14T10:22:11 UTC UTC",
                                 "2022-04-14T10:22:11TAI",
                                 "2022-04-14T10:22:11ZZ",
                                 " 2022-04-14T10:22:11",
                                 "-022-04-14T10:22:11",
                                 "2022-04-14T10:22:1e",
                                 "2022-04-14T10:22:11.5e3",
                                 "2022-04-14T10:22:11.1234567890123"}) {
    EXPECT_EQ(refusal(text), "epoch '" + text + "' in UTC: it is not written as 2022-04-14T10:22:11.874999");
  }
  EXPECT_THROW(Epoch::from_tt("2022-04-14T10:22:11Z"), BadInput);
}

TEST(Epoch, RefusesDatesThatDoNotExist) {
  const auto wrong = [](const std::string& text, const std::string& reason) {
    EXPECT_EQ(refusal(text), "epoch '" + text + "' in UTC: " + reason);
  };
  wrong("2022-13-14T10:22:11", "there is no such month");
  wrong("2022-00-14T10:22:11", "there is no such month");
  wrong("2022-02-29T10:22:11", "there is no such day");
  wrong("2022-04-14T24:00:00", "there is no such hour");
  wrong("2022-04-14T10:60:11", "there is no such minute");
  wrong("2022-04-14T10:22:60", "there is no such second");
  wrong("2022-04-14T23:59:60", "there is no such second");
  wrong("2016-12-31T23:59:61", "there is no such second");
  wrong("1959-12-31T23:59:59", "UTC is not known before 1960");
}

TEST(Epoch, RefusesUtcBefore1960) {
  const auto epoch = Epoch::from_tt("1950-01-01T00:00:32.184");
  EXPECT_EQ(epoch.tt(0), "1950-01-01T00:00:32");
  EXPECT_EQ(complaint([&] { (void)epoch.utc(); }),
            "Epoch 1950-01-01T00:00:00.000000 TAI: UTC is not known before 1960");
  EXPECT_THROW((void)epoch.tai_minus_utc(), BadInput);
}

TEST(Epoch, TakesTheLastKnownLeapSecondInTheFuture) {
  EXPECT_EQ(seconds(Epoch::from_utc("2035-01-01T00:00:00").tai_minus_utc()), 37.0);
}

TEST(Epoch, RefusesDurationsThatAreNotFinite) {
  const auto epoch = Epoch::from_utc("2022-04-14T10:22:11");
  EXPECT_EQ(complaint([&] { epoch + std::numeric_limits<double>::infinity() * si::second; }),
            "epoch + duration: the duration is inf s");
  EXPECT_THROW(epoch - std::numeric_limits<double>::quiet_NaN() * si::second, BadInput);
  EXPECT_THROW((void)(epoch + 1e20 * si::second).tt(), BadInput);
  EXPECT_THROW((void)epoch.utc(-1), BadInput);
  EXPECT_THROW((void)epoch.utc(10), BadInput);
}

}  // namespace
}  // namespace vectrix::epoch_test
