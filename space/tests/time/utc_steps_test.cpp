#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <vectrix/space/time/epoch.hpp>
#include <vectrix/space/time/exact_text.hpp>
#include <vectrix/space/time/leap_seconds.hpp>

#include "temporary_file.hpp"

namespace vectrix::utc_steps_test {
namespace {

// The fraction of a day is stored to 1e-16 day, 1e-11 s; two conversions and a difference round it four
// times.
constexpr double clock_rounding = 5e-11;   // s
constexpr double number_rounding = 1e-13;  // s: of some operations on TAI-UTC, which is below 50 s

constexpr double drift_within_a_step = 0.11 * 3.1e-8;  // s: TAI-UTC grew by 3e-8 of the time at most

// From a modified Julian day on, TAI-UTC = offset + (MJD - since) rate, in s.
struct Line {
  int first;
  double offset, since, rate;

  [[nodiscard]] double operator()(double mjd) const { return offset + (mjd - since) * rate; }
};

// As the International Earth Rotation Service publishes it (UTC-TAI.history), and the leap seconds.
std::vector<Line> lines() {
  std::vector<Line> all{{36934, 1.4178180, 37300, 0.001296},  {37300, 1.4228180, 37300, 0.001296},
                        {37512, 1.3728180, 37300, 0.001296},  {37665, 1.8458580, 37665, 0.0011232},
                        {38334, 1.9458580, 37665, 0.0011232}, {38395, 3.2401300, 38761, 0.001296},
                        {38486, 3.3401300, 38761, 0.001296},  {38639, 3.4401300, 38761, 0.001296},
                        {38761, 3.5401300, 38761, 0.001296},  {38820, 3.6401300, 38761, 0.001296},
                        {38942, 3.7401300, 38761, 0.001296},  {39004, 3.8401300, 38761, 0.001296},
                        {39126, 4.3131700, 39126, 0.002592},  {39887, 4.2131700, 39126, 0.002592}};
  for (const LeapSecond& leap : leap_seconds()) {
    const std::string month = (leap.month < 10 ? "-0" : "-") + std::to_string(leap.month);
    const auto at = Epoch::from_tt(std::to_string(leap.year) + month + "-01T12:00:00");
    all.push_back(
        {static_cast<int>(at.tt_date().modified_day()), static_cast<double>(leap.tai_minus_utc), 0.0, 0.0});
  }
  return all;
}

std::string day_of(int mjd) {
  return Epoch::from_modified_julian_date(scale::tt, mjd).tt(0).substr(0, 10);
}

double difference(const Epoch& t) {
  return t.tai_minus_utc().value();
}

TEST(UtcSteps, MidnightIsAfterTheStep) {
  for (const Line& line : lines()) {
    const std::string day = day_of(line.first), written = day + "T00:00:00";
    const auto t = Epoch::from_utc(written);
    const double expected = line(line.first);
    EXPECT_NEAR(difference(t), expected, number_rounding) << day;
    EXPECT_EQ(t.utc(0), written);
    for (int decimals = 1; decimals <= 9; ++decimals)
      EXPECT_EQ(t.utc(decimals), written + "." + std::string(static_cast<std::size_t>(decimals), '0'));
    EXPECT_EQ(exact_text(t, scale::utc), written + ".000");
    const auto date = t.julian_date(scale::utc);
    EXPECT_EQ(date.modified_day(), line.first);
    EXPECT_EQ(date.fraction, 0.0);
    EXPECT_EQ(Epoch::from_utc_mjd(line.first), t) << day;
    EXPECT_EQ(Epoch::from_julian_date(date), t) << day;
    EXPECT_NEAR((t - Epoch::from(scale::tai, written)).value(), expected, clock_rounding) << day;
  }
}

TEST(UtcSteps, Ut1ByUtcIsThatOfTheDayAfterTheStep) {
  for (const Line& line : lines()) {
    const auto t = Epoch::from_utc(day_of(line.first) + "T00:00:00");
    for (int i = -19; i <= 19; ++i) {
      const double ut1_minus_utc = 0.047 * i;
      const auto ut1 = scale::Ut1::minus_utc(ut1_minus_utc * si::second);
      const auto date = t.julian_date(ut1);
      EXPECT_NEAR(((date.modified_day() - line.first) + date.fraction) * 86400.0, ut1_minus_utc,
                  clock_rounding)
          << line.first;
      EXPECT_LE(std::abs((Epoch::from_julian_date(date) - t).value()), clock_rounding) << line.first;
    }
  }
}

// By the second of UTC since midnight, also on the day that a step makes longer or shorter.
TEST(UtcSteps, TaiMinusUtcIsALineBetweenTwoOfThem) {
  const auto all = lines();
  const auto expect_line = [](const Line& line, int mjd) {
    for (const auto& [time, second] : {std::pair{"T00:00:00", 0.0},
                                       {"T07:12:00", 25920.0},
                                       {"T12:00:00", 43200.0},
                                       {"T23:59:59", 86399.0}}) {
      const std::string text = day_of(mjd) + time;
      const auto t = Epoch::from_utc(text);
      const double expected = line(mjd + second / 86400.0);
      EXPECT_NEAR((t - Epoch::from(scale::tai, text)).value(), expected, clock_rounding) << text;
      // A clock's rounding moves the difference by 1e-8 of it.
      EXPECT_NEAR(difference(t), expected, number_rounding) << text;
    }
  };
  for (std::size_t i = 1; i < all.size(); ++i) {
    expect_line(all[i - 1], all[i].first - 1);
    expect_line(all[i], all[i].first);
  }
}

// Time goes on: no instant of TAI has two in UTC, and none of UTC two in TAI.
TEST(UtcSteps, UtcGrowsWithTaiAcrossAStep) {
  const auto all = lines();
  for (std::size_t i = 1; i < all.size(); ++i) {
    const auto midnight = Epoch::from_utc(day_of(all[i].first) + "T00:00:00");
    auto before = midnight - 6e-9 * si::second;
    for (double off = -5.8e-9; off < 6e-9; off += 0.2e-9) {
      const auto t = midnight + off * si::second;
      EXPECT_NEAR(difference(t), (t < midnight ? all[i - 1] : all[i])(all[i].first), drift_within_a_step)
          << off;
      EXPECT_LE(before.utc(9), t.utc(9)) << off;
      EXPECT_LE(before.julian_date(scale::utc), t.julian_date(scale::utc)) << off;
      EXPECT_LE(std::abs((Epoch::from_utc(t.utc(9)) - t).value()), 0.5e-9 + clock_rounding) << t.utc(9);
      EXPECT_LE(std::abs((Epoch::from_utc(exact_text(t, scale::utc)) - t).value()), clock_rounding) << off;
      before = t;
    }
  }
}

// 0.1 s of TAI are 1.5 ns less of UTC, of which a second had 1 + 1.5e-8 s of TAI.
TEST(UtcSteps, ADayEndsWhereTheNextBegins) {
  EXPECT_EQ(complaint([] { Epoch::from_utc("1965-08-31T23:59:60.099999999"); }),
            "epoch '1965-08-31T23:59:60.099999999' in UTC: there is no such second");
  const auto end = Epoch::from_utc("1965-08-31T23:59:60.099999998");
  const auto midnight = Epoch::from_utc("1965-09-01T00:00:00");
  EXPECT_NEAR((midnight - end).value(), 0.5e-9, clock_rounding);
  EXPECT_EQ(end.utc(9), "1965-08-31T23:59:60.099999998");
  EXPECT_EQ(end.utc(8), "1965-09-01T00:00:00.00000000");
}

}  // namespace
}  // namespace vectrix::utc_steps_test
