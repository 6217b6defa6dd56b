#include <gtest/gtest.h>

#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "temporary_file.hpp"

namespace vectrix::ut1_test {
namespace {

// The fraction of a day is stored to 1e-16 day, 1e-11 s; two conversions and a difference round it four
// times.
constexpr double clock_rounding = 5e-11;  // s

double apart(const Epoch& a, const Epoch& b) {
  return std::abs((a - b).value());
}

// A table of Earth orientation and its successor differ by microseconds, a forgotten leap second by one.
TEST(Ut1, OfAnotherSourceIsRefused) {
  const auto t = Epoch::from_utc("2022-04-14T10:22:11");
  const auto early = scale::Ut1::minus_tai(-37.09912 * si::second),
             late = scale::Ut1::minus_tai(-37.09913 * si::second);
  const auto text = t.text(early, 6);
  EXPECT_EQ(complaint([&] { Epoch::from(late, text); }),
            "epoch '2022-04-14T10:22:10.900880' in UT1 with UT1-TAI -37.09913 s: it was written with UT1-TAI "
            "-37.09912 s");
  EXPECT_EQ(
      complaint([&] { Epoch::from(scale::Ut1::minus_utc(-0.2 * si::second), t.day_of_year_text(early)); }),
      "epoch '2022-104T10:22:10.900880' in UT1 with UT1-UTC -0.2 s: it was written with UT1-TAI "
      "-37.09912 s");
  EXPECT_THROW(Epoch::from(late, exact_text(t, early)), BadInput);
  EXPECT_LE(apart(Epoch::from(early, text), t), clock_rounding);
  // A date knows its own.
  EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(early)), t), clock_rounding);
  EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(late)), t), clock_rounding);
}

// UT1-UTC for UT1-TAI is 37 s off, and says so in every way in and out.
TEST(Ut1, MinusUtcGivenAsUt1MinusTaiIsRefused) {
  const auto wrong = scale::Ut1::minus_tai(-0.1 * si::second);
  const auto t = Epoch::from_utc("2018-04-14T10:22:11");
  const std::string reason =
      "UT1-TAI is -0.1 s, so UT1-UTC 36.9 s; it must be within 0.9 s (UTC keeps it below 0.9 s); UT1-TAI = "
      "(UT1-UTC) - (TAI-UTC)";
  EXPECT_EQ(complaint([&] { Epoch::from(wrong, "2018-04-14T10:22:11.4"); }),
            "epoch '2018-04-14T10:22:11.4' in UT1: " + reason);
  EXPECT_EQ(complaint([&] {
              Epoch::from_julian_date(JulianDate<scale::Ut1>{2458222.5, 0.25, wrong});
            }),
            "Julian date 2458222.5 + 0.25 in UT1: " + reason);
  EXPECT_EQ(complaint([&] { (void)t.text(wrong); }), "Epoch 2018-04-14T10:22:48.000000 TAI: " + reason);
  EXPECT_THROW((void)t.day_of_year_text(wrong), BadInput);
  EXPECT_THROW((void)exact_text(t, wrong), BadInput);
  EXPECT_THROW((void)t.julian_date(wrong), BadInput);
  EXPECT_THROW(Epoch::from_modified_julian_date(wrong, 58222.0), BadInput);
  // A leap second too many where all are known. Later five may be missing in the table; before 1972 UTC kept
  // to UT1 by other steps.
  EXPECT_NO_THROW((void)t.text(scale::Ut1::minus_tai(-36.1 * si::second)));
  EXPECT_THROW((void)t.text(scale::Ut1::minus_tai(-36.05 * si::second)), BadInput);
  EXPECT_THROW((void)t.text(scale::Ut1::minus_tai(-38.2 * si::second)), BadInput);
  const auto later = Epoch::from_utc("2060-04-14T10:22:11");
  EXPECT_NO_THROW((void)later.text(scale::Ut1::minus_tai(-41.9 * si::second)));
  EXPECT_EQ(
      complaint([&] { (void)later.text(scale::Ut1::minus_tai(-42.5 * si::second)); }),
      "Epoch 2060-04-14T10:22:48.000000 TAI: UT1-TAI is -42.5 s, so UT1-UTC -5.5 s; it must be within 5 "
      "s (UTC keeps it below 0.9 s, leap seconds may be missing); UT1-TAI = (UT1-UTC) - (TAI-UTC)");
  EXPECT_NO_THROW((void)Epoch::from_utc("1971-12-31T23:59:59").text(wrong));
  EXPECT_THROW((void)Epoch::from_utc("1972-01-01T00:00:00").text(wrong), BadInput);
}

// What UT1-UTC writes it reads back, up to a leap second and after it.
TEST(Ut1, ByUtcDoesNotNameALeapSecond) {
  const auto ut1 = scale::Ut1::minus_utc(-0.4 * si::second);
  const auto midnight = Epoch::from_utc("2017-01-01T00:00:00");
  for (const double seconds : {-86000.0, -2.0, -1.001, 0.0, 1e-3, 0.5, 1.0, 86000.0}) {
    const Epoch t = midnight + seconds * si::second;
    EXPECT_LE(apart(Epoch::from(ut1, t.text(ut1, 9)), t), 0.5e-9 + clock_rounding) << seconds;
    EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(ut1)), t), clock_rounding) << seconds;
  }
  for (const double seconds : {-1.0, -0.5, -1e-9}) {
    const Epoch t = midnight + seconds * si::second;
    const auto complaint_of = complaint([&] { (void)t.text(ut1); });
    EXPECT_NE(complaint_of.find("UT1-UTC names no instant of a leap second; take Ut1::minus_tai"),
              std::string::npos)
        << complaint_of;
    EXPECT_THROW((void)t.julian_date(ut1), BadInput);
    EXPECT_THROW((void)exact_text(t, ut1), BadInput);
    const auto by_tai = scale::Ut1::minus_tai(-36.4 * si::second);
    EXPECT_LE(apart(Epoch::from(by_tai, t.text(by_tai, 9)), t), 0.5e-9 + clock_rounding) << seconds;
  }
}

}  // namespace
}  // namespace vectrix::ut1_test
