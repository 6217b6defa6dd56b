#include <gtest/gtest.h>

#include <vectrix/space/time/epoch.hpp>
#include <vectrix/space/time/leap_seconds.hpp>

#include "temporary_file.hpp"

namespace vectrix::leap_seconds_test {
namespace {

// Gives back the table that was there before.
class LeapSeconds : public ::testing::Test {
 protected:
  ~LeapSeconds() override { use_leap_seconds(installed); }

  std::vector<LeapSecond> with(std::vector<LeapSecond> more) const {
    std::vector<LeapSecond> table = installed;
    table.insert(table.end(), more.begin(), more.end());
    return table;
  }

  const std::vector<LeapSecond> installed = leap_seconds();
};

TEST_F(LeapSeconds, AreThoseOfTheIers) {
  EXPECT_EQ(installed.front(), (LeapSecond{1972, 1, 10}));
  ASSERT_GE(installed.size(), 28U);
  EXPECT_EQ(installed[1], (LeapSecond{1972, 7, 11}));
  EXPECT_EQ(installed[27], (LeapSecond{2017, 1, 37}));
}

// One announced for the end of 2034, and, what has never been, a negative one after it.
TEST_F(LeapSeconds, OfTheFutureCanBeGiven) {
  const auto before = Epoch::from(scale::tai, "2035-06-01T00:00:00");
  EXPECT_EQ(before.utc(0), "2035-05-31T23:59:23");
  EXPECT_THROW((void)Epoch::from_utc("2034-12-31T23:59:60.5"), BadInput);
  use_leap_seconds(with({{2035, 1, 38}, {2036, 1, 37}}));
  EXPECT_EQ(leap_seconds(), with({{2035, 1, 38}, {2036, 1, 37}}));
  EXPECT_EQ(before.utc(0), "2035-05-31T23:59:22");  // the instant is the same, its date another
  const auto within = Epoch::from_utc("2034-12-31T23:59:60.5");
  EXPECT_EQ(within.text(scale::tai, 1), "2035-01-01T00:00:37.5");
  EXPECT_EQ(Epoch::from_utc("2035-01-01T00:00:00") - Epoch::from_utc("2034-12-31T00:00:00"),
            86401.0 * si::second);
  EXPECT_EQ(Epoch::from_utc("2036-01-01T00:00:00") - Epoch::from_utc("2035-12-31T00:00:00"),
            86399.0 * si::second);
  // Before 1972 all is as it was: 4.31317 s + (39856 - 39126) days of 0.002592 s.
  EXPECT_EQ(Epoch::from_utc("1968-01-01T00:00:00").text(scale::tai, 6), "1968-01-01T00:00:06.205330");
}

TEST_F(LeapSeconds, ATableThatCannotBe) {
  const auto refused = [](const std::vector<LeapSecond>& table) {
    return complaint([&] { use_leap_seconds(table); });
  };
  EXPECT_EQ(refused({}), "use_leap_seconds: the table does not begin with 1972-01, 10 s");
  EXPECT_EQ(refused(with({{2016, 1, 38}})), "use_leap_seconds: 2016-01, 38 s does not follow 2017-01, 37 s");
  EXPECT_EQ(refused(with({{2035, 13, 38}})), "use_leap_seconds: 2035-13, 38 s does not follow 2017-01, 37 s");
  EXPECT_EQ(refused(with({{2035, 1, 39}})),
            "use_leap_seconds: 2035-01, 39 s is not one second from 2017-01, 37 s");
  EXPECT_EQ(refused({{1972, 1, 10}, {1972, 7, 11}}),
            "use_leap_seconds: the table ends where ERFA has 1973-01, 12 s");
  EXPECT_EQ(refused({{1972, 1, 10}, {1972, 10, 11}}),
            "use_leap_seconds: there is 1972-10, 11 s where ERFA has 1972-07, 11 s");
  EXPECT_EQ(leap_seconds(), installed);
}

TEST_F(LeapSeconds, FromTheFileOfTheIers) {
  const std::string start = "#  Value of TAI-UTC in second valid between\n";
  const TemporaryFile file(start + "    41317.0    1  1 1972       10\n    41499.0    1  7 1972       11\n");
  EXPECT_EQ(read_leap_seconds(file.path()), (std::vector<LeapSecond>{{1972, 1, 10}, {1972, 7, 11}}));
  const auto refusal = [&](const std::string& lines) {
    const TemporaryFile wrong(start + lines);
    return complaint([&] { (void)read_leap_seconds(wrong.path()); }, wrong.path());
  };
  EXPECT_EQ(refusal("    41318.0    1  1 1972       10\n"),
            "leap seconds FILE, line 2, column 1: the modified Julian day 41318 is not the first of the "
            "month 1972-1");
  EXPECT_EQ(refusal("    41317.0    1  x 1972       10\n"),
            "leap seconds FILE, line 2, column 19: 'x' is not a whole number");
  EXPECT_EQ(refusal("    41317.0    1  1 1972\n"),
            "leap seconds FILE, line 2, column 25: '' is not a whole number");
  EXPECT_EQ(refusal("    41317.0    1  1 1972       10  s\n"),
            "leap seconds FILE, line 2, column 34: five numbers are expected");
  EXPECT_EQ(refusal("    41317.0    1  1 1972       10"),
            "leap seconds FILE, line 2: the file stops within this line; it was truncated");
  // One second from the row before, it is whole.
  const std::string first = "    41317.0    1  1 1972       10\n", next = "    41499.0    1  7 1972       11";
  EXPECT_EQ(refusal(first + next), "nothing was thrown");
  EXPECT_EQ(refusal(first + next.substr(0, next.size() - 1)),
            "leap seconds FILE, line 3: the file stops within this line; it was truncated");
  EXPECT_EQ(refusal(""), "leap seconds FILE: there are no rows");
  const TemporaryFile empty("");
  EXPECT_EQ(complaint([&] { (void)read_leap_seconds(empty.path()); }, empty.path()),
            "leap seconds FILE: there are no rows");
  EXPECT_EQ(complaint([] { (void)read_leap_seconds("/nowhere/at/all"); }),
            "leap seconds /nowhere/at/all: cannot be read");
}

}  // namespace
}  // namespace vectrix::leap_seconds_test
