#include <erfa.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "temporary_file.hpp"

// ERFA is the independent check: its functions are called here with dates as they come.
namespace vectrix::time_scale_test {
namespace {

// The fraction of a day is stored to 1e-16 day, 1e-11 s; two conversions and a difference round it four
// times.
constexpr double clock_rounding = 5e-11;  // s
constexpr double day = 86400.0;           // s
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double seconds(const Quantity<si::time>& t) {
  return t.value();
}
double apart(const Epoch& a, const Epoch& b) {
  return std::abs(seconds(a - b));
}
template <class Scale> double apart(const JulianDate<Scale>& date, double other_day, double other_fraction) {
  return std::abs((date.day - other_day) + (date.fraction - other_fraction)) * day;
}

// UT1 as it may be at an instant.
std::vector<TimeScale> uniform_scales(const Epoch& at) {
  return {scale::tai, scale::tt, scale::tdb, scale::gps,
          scale::Ut1::minus_tai(-at.tai_minus_utc() - 0.1 * si::second)};
}

// A random instant from 1980 to 2050, with every bit of the clock in use.
rc::Gen<Epoch> epoch_since_1980() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(44300, 69000), rc::gen::inRange(0, 1'000'000'000)),
                      [](const auto& at) {
                        return Epoch::from_modified_julian_date(scale::tai, at.first, at.second * 1e-9);
                      });
}

TEST(TimeScale, KnownPairs) {
  // GPS began when TAI-UTC was 19 s. J2000 is 12 h TT.
  EXPECT_LE(apart(Epoch::from(scale::gps, "1980-01-06T00:00:00"), Epoch::from_utc("1980-01-06T00:00:00")),
            clock_rounding);
  EXPECT_EQ(Epoch::from_utc("2022-04-14T00:00:00").text(scale::gps), "2022-04-14T00:00:18.000000");
  EXPECT_EQ(Epoch::from_utc("2022-04-14T00:00:00").text(scale::tai), "2022-04-14T00:00:37.000000");
  EXPECT_EQ(Epoch::from_tt("2000-01-01T12:00:00").text(scale::utc, 3), "2000-01-01T11:58:55.816");
  const auto j2000 = Epoch::from_tt("2000-01-01T12:00:00").julian_date(scale::tt);
  EXPECT_LE(apart(j2000, 2451545.0, 0.0), clock_rounding);
  EXPECT_EQ(j2000.modified_day(), 51544.0);
}

TEST(TimeScale, GpsWeeksCountOnWhereReceiversRollOver) {
  const auto begins = [](const char* utc, std::int64_t week) {
    EXPECT_EQ(Epoch::from_utc(utc).gps_time(), (GpsTime{week, 0.0 * si::second})) << utc;
    EXPECT_LE(apart(Epoch::from_gps_week(week, 0.0 * si::second), Epoch::from_utc(utc)), clock_rounding);
  };
  begins("1980-01-06T00:00:00", 0);
  begins("1999-08-21T23:59:47", 1024);
  begins("2019-04-06T23:59:42", 2048);
  // Leap seconds since 1980: 1366002078 s is 2023-04-20T05:00:60 UTC less 18 s.
  const auto flight = Epoch::from_gps_seconds(1366002078);
  EXPECT_EQ(flight.utc(3), "2023-04-20T05:01:00.000");
  EXPECT_EQ(flight.gps_time(), (GpsTime{2258, 363678.0 * si::second}));
  EXPECT_EQ(flight.gps_time().since_1980().value(), 1366002078.0);
  // 2e-11 s before a week is its beginning, to 1e-10 s.
  const auto week = Epoch::from_gps_week(2048, 0.0 * si::second);
  EXPECT_EQ((week - 2e-11 * si::second).gps_time(), week.gps_time());
  EXPECT_EQ((week - 1.0 * si::second).gps_time(), (GpsTime{2047, 604799.0 * si::second}));
  EXPECT_LT(Epoch::from_utc("2019-04-06T23:59:41").gps_time(),
            Epoch::from_utc("2019-04-06T23:59:42").gps_time());
}

RC_GTEST_PROP(TimeScale, GpsTimeIsReadBack, ()) {
  const auto epoch = *epoch_since_1980();
  const auto gps = epoch.gps_time();
  constexpr double rounded = 1e-10;  // s
  RC_ASSERT(gps.second.value() >= 0.0 && gps.second.value() < 7 * day);
  RC_ASSERT(apart(Epoch::from_gps_week(gps.week, gps.second), epoch) <= rounded + clock_rounding);
  const auto whole = static_cast<std::int64_t>(gps.second.value());
  const double fraction = gps.second.value() - static_cast<double>(whole);
  RC_ASSERT(apart(Epoch::from_gps_seconds(gps.week * 604800 + whole, fraction), epoch) <=
            rounded + clock_rounding);
}

TEST(TimeScale, LeapSecondsAreThoseOfErfa) {
  for (int year = 1972; year <= 2026; ++year) {
    for (const int month : {1, 7}) {
      const std::string date = std::to_string(year) + (month == 1 ? "-01-01" : "-07-01");
      double expected = 0.0;
      eraDat(year, month, 1, 0.0, &expected);
      const auto epoch = Epoch::from_utc(date + "T00:00:00");
      EXPECT_EQ(seconds(epoch.tai_minus_utc()), expected) << date;
      const auto before = epoch - 1.0 * si::second;
      const double step = expected - seconds(before.tai_minus_utc());
      EXPECT_EQ(before.utc(0).substr(17), step == 1.0 ? "60" : "59") << date;
    }
  }
}

// 1960 to 1972: TAI - UTC grew by some 1e-8 of the time, with steps.
TEST(TimeScale, RatesBefore1972AreThoseOfErfa) {
  // At midnight after a step of 0.1 s ERFA's TAI(UTC) jumps by the drift within the step.
  constexpr double drift_within_a_step = 0.1 * 1.6e-8;  // s
  for (int mjd = 36934; mjd < 41317; mjd += 7) {
    for (const double part : {0.0, 0.3, 0.99}) {
      const auto epoch = Epoch::from_modified_julian_date(scale::utc, mjd, part);
      double tai = 0.0;
      double fraction = 0.0;
      ASSERT_GE(eraUtctai(2400000.5 + mjd, part, &tai, &fraction), 0);
      EXPECT_LE(apart(epoch.tai(), tai, fraction), clock_rounding) << mjd;
      EXPECT_LE(apart(epoch.julian_date(scale::utc), 2400000.5 + mjd, part),
                part == 0.0 ? drift_within_a_step : clock_rounding)
          << mjd;
    }
  }
}

RC_GTEST_PROP(TimeScale, DatesAreThoseOfErfa, ()) {
  const auto epoch = *epoch_since_1980();
  const double d = epoch.tai().day;
  const double f = epoch.tai().fraction;
  double day1 = 0.0;
  double day2 = 0.0;
  eraTaitt(d, f, &day1, &day2);
  RC_ASSERT(apart(epoch.julian_date(scale::tt), day1, day2) <= clock_rounding);
  const double tdb_minus_tt = eraDtdb(day1, day2, 0.0, 0.0, 0.0, 0.0);
  RC_ASSERT(std::abs(tdb_minus_tt) < 2e-3 && std::abs(tdb_minus_tt) > 0.0);
  double tdb1 = 0.0;
  double tdb2 = 0.0;
  eraTttdb(day1, day2, tdb_minus_tt, &tdb1, &tdb2);
  RC_ASSERT(apart(epoch.julian_date(scale::tdb), tdb1, tdb2) <= clock_rounding);
  RC_ASSERT(apart(epoch.julian_date(scale::gps), d, f - 19.0 / day) <= clock_rounding);
  const double ut1_minus_utc = 0.31;
  double utc1 = 0.0;
  double utc2 = 0.0;
  RC_ASSERT(eraTaiutc(d, f, &utc1, &utc2) >= 0);
  RC_ASSERT(apart(epoch.julian_date(scale::utc), utc1, utc2) <= clock_rounding);
  RC_ASSERT(eraUtcut1(utc1, utc2, ut1_minus_utc, &day1, &day2) >= 0);
  const auto ut1 = scale::Ut1::minus_utc(ut1_minus_utc * si::second);
  RC_ASSERT(apart(epoch.julian_date(ut1), day1, day2) <= clock_rounding);
  RC_ASSERT(apart(Epoch::from_julian_date(ut1, day1, day2), epoch) <= clock_rounding);
  const auto ut1_minus_tai = ut1_minus_utc * si::second - epoch.tai_minus_utc();
  eraTaiut1(d, f, ut1_minus_tai.value(), &day1, &day2);
  RC_ASSERT(apart(epoch.julian_date(scale::Ut1::minus_tai(ut1_minus_tai)), day1, day2) <= clock_rounding);
}

// The difference of TDB and TT by its largest terms, of which the others leave out 40 microseconds at most.
RC_GTEST_PROP(TimeScale, TdbFollowsTheEarthsOrbit, ()) {
  const auto epoch = *epoch_since_1980();
  const auto tt = epoch.julian_date(scale::tt);
  const auto tdb = epoch.julian_date(scale::tdb);
  const double days = (tt.day - 2451545.0) + tt.fraction;
  const double anomaly = 6.24 + 0.01720197 * days;
  const double difference = ((tdb.day - tt.day) + (tdb.fraction - tt.fraction)) * day;
  RC_ASSERT(std::abs(difference - 0.001657 * std::sin(anomaly) - 0.000022 * std::sin(2.0 * anomaly)) < 4e-5);
}

RC_GTEST_PROP(TimeScale, JulianDatesAreReadBackHoweverTheyAreSplit, ()) {
  const auto epoch = *epoch_since_1980();
  for (const TimeScale& in : uniform_scales(epoch)) {
    const auto text = epoch.text(in, 9);
    RC_ASSERT(Epoch::from(in, text).text(in, 9) == text);
  }
  const auto date = epoch.julian_date(scale::tdb);
  RC_ASSERT(date.fraction >= 0.0 && date.fraction < 1.0 && std::fmod(date.day, 1.0) == 0.5);
  const double moved = *rc::gen::inRange(-3'000'000, 3'000'000);
  RC_ASSERT(apart(Epoch::from_julian_date(scale::tdb, date.day, date.fraction), epoch) <= clock_rounding);
  RC_ASSERT(apart(Epoch::from_julian_date(scale::tdb, date.fraction, date.day), epoch) <= clock_rounding);
  RC_ASSERT(Epoch::from_julian_date(scale::tdb, date.day + moved, -moved) ==
            Epoch::from_julian_date(scale::tdb, date.day));
  RC_ASSERT(apart(Epoch::from_modified_julian_date(scale::tdb, date.modified_day(), date.fraction), epoch) <=
            clock_rounding);
}

TEST(TimeScale, WritesTheSameTextForAScaleInATypeAndAtRunTime) {
  const auto t = Epoch::from_utc("2016-12-31T23:59:60.25");
  const TimeScale& gps = scale::gps;
  const DateText<scale::Gps> text = t.text(scale::gps, 3);
  const DateText<scale::Gps> by_day_of_year = t.day_of_year_text(scale::gps, 3);
  EXPECT_EQ(text, "2017-01-01T00:00:17.250");
  EXPECT_EQ(t.text(gps, 3), text);
  EXPECT_EQ(by_day_of_year, "2017-001T00:00:17.250");
  EXPECT_EQ(t.day_of_year_text(gps, 3), by_day_of_year);
  const DateText<scale::Gps> exact = exact_text(t, scale::gps);
  EXPECT_EQ(exact_text(t, gps), exact);
}

TEST(TimeScale, ATextIsNotReadInAnotherScaleThatIsKnownAtRunTime) {
  const auto t = Epoch::from_utc("2016-12-31T23:59:60.25");
  const auto text = t.text(scale::gps, 3);
  const auto read_in = [&](const TimeScale& scale) {
    return complaint([&] { EXPECT_LT(std::abs((Epoch::from(scale, text) - t).value()), clock_rounding); });
  };
  EXPECT_EQ(read_in(scale::gps), "nothing was thrown");
  EXPECT_EQ(read_in(scale::tt), "epoch '2017-01-01T00:00:17.250' in TT: it was written in GPS");
  // UT1 may be known by another difference than the one it was written with, if it is of the same instant. In
  // a leap second UT1-UTC is that of the second after it.
  const auto by_tai = scale::Ut1::minus_tai(-36.4 * si::second);
  const TimeScale& by_utc = scale::Ut1::minus_utc(0.6 * si::second);
  const auto later = Epoch::from_utc("2017-01-01T12:00:00");
  EXPECT_LE(apart(Epoch::from(by_utc, later.text(by_tai)), later), clock_rounding);
  EXPECT_THROW(Epoch::from(by_utc, t.text(by_tai, 3)), BadInput);
}

// 9 decimals, a nanosecond, of the 11 that an epoch has.
RC_GTEST_PROP(TimeScale, TextIsReadBackToTheLastDigit, ()) {
  const auto epoch = *epoch_since_1980();
  for (const TimeScale& in : uniform_scales(epoch)) {
    const auto text = epoch.text(in, 9);
    const auto by_day_of_year = epoch.day_of_year_text(in, 9);
    RC_ASSERT(Epoch::from(in, text).text(in, 9) == text);
    RC_ASSERT(Epoch::from(in, by_day_of_year).day_of_year_text(in, 9) == by_day_of_year);
    RC_ASSERT(apart(Epoch::from(in, text), epoch) <= 0.5e-9 + clock_rounding);
    RC_ASSERT(apart(Epoch::from(in, by_day_of_year), Epoch::from(in, text)) <= clock_rounding);
  }
  RC_ASSERT(Epoch::from_utc(epoch.utc(9)).utc(9) == epoch.utc(9));
}

TEST(TimeScale, ADayOfTheYearIsThatOfTheCalendar) {
  EXPECT_EQ(Epoch::from_utc("2022-104T10:22:11.874999Z"), Epoch::from_utc("2022-04-14T10:22:11.874999"));
  EXPECT_EQ(Epoch::from_utc("2016-366T23:59:60.5").day_of_year_text(scale::utc, 1), "2016-366T23:59:60.5");
  EXPECT_EQ(Epoch::from_tt("2000-060T00:00:00").tt(0), "2000-02-29T00:00:00");
  EXPECT_EQ(Epoch::from_tt("1900-060T00:00:00").tt(0), "1900-03-01T00:00:00");
  EXPECT_EQ(Epoch::from_tt("2021-365T23:59:59.7").day_of_year_text(scale::tt, 0), "2022-001T00:00:00");
  for (const std::string text : {"2022-366T00:00:00", "2022-000T00:00:00", "2016-367T00:00:00"}) {
    EXPECT_EQ(complaint([&] { Epoch::from(scale::tdb, text); }),
              "epoch '" + text + "' in TDB: there is no such day");
  }
  EXPECT_THROW(Epoch::from_tt("2022-04T00:00:00"), BadInput);
  EXPECT_THROW(Epoch::from_tt("2022-1045T00:00:00"), BadInput);
}

TEST(TimeScale, OnlyUtcHasLeapSecondsAndZ) {
  for (const TimeScale& in : uniform_scales(Epoch::from_utc("2016-12-31T00:00:00"))) {
    EXPECT_EQ(complaint([&] { Epoch::from(in, "2016-12-31T23:59:60"); }),
              std::string{"epoch '2016-12-31T23:59:60' in "} + in.name() + ": there is no such second");
    EXPECT_THROW(Epoch::from(in, "2016-12-31T23:59:59Z"), BadInput);
  }
}

TEST(TimeScale, RefusesGpsBefore1980AndUtcBefore1960) {
  EXPECT_EQ(complaint([] { Epoch::from(scale::gps, "1980-01-05T23:59:59"); }),
            "epoch '1980-01-05T23:59:59' in GPS: GPS time begins in 1980");
  const auto early = Epoch::from_utc("1980-01-05T23:59:59");
  EXPECT_EQ(complaint([&] { (void)early.text(scale::gps); }),
            "Epoch 1980-01-06T00:00:18.000000 TAI: GPS time begins in 1980");
  EXPECT_THROW((void)early.gps_time(), BadInput);
  EXPECT_THROW(Epoch::from_julian_date(scale::utc, 2436934.0), BadInput);
  EXPECT_THROW(Epoch::from_julian_date(scale::Ut1::minus_utc(0.1 * si::second), 2436934.0), BadInput);
}

TEST(TimeScale, RefusesNumbersOutOfRange) {
  EXPECT_EQ(complaint([] { Epoch::from_gps_week(-1, 0.0 * si::second); }),
            "GPS week -1, second 0: the week is outside [0, 1000000]");
  EXPECT_EQ(complaint([] { Epoch::from_gps_week(2258, 604800.0 * si::second); }),
            "GPS week 2258, second 604800: the second is outside [0, 604800)");
  EXPECT_THROW(Epoch::from_gps_week(2258, not_a_number * si::second), BadInput);
  EXPECT_THROW(Epoch::from_gps_seconds(-1), BadInput);
  EXPECT_THROW(Epoch::from_gps_seconds(1, 1.0), BadInput);
  EXPECT_THROW(Epoch::from_gps_seconds(1, not_a_number), BadInput);
  EXPECT_EQ(complaint([] { Epoch::from_julian_date(scale::tt, infinity); }),
            "Julian date inf + 0 in TT: it is not finite");
  EXPECT_THROW(Epoch::from_modified_julian_date(scale::tt, 1.0, not_a_number), BadInput);
  EXPECT_EQ(complaint([] { (void)scale::Ut1::minus_utc(-37.1 * si::second); }),
            "Ut1::minus_utc: UT1-UTC is -37.1 s; UTC keeps it within 0.9 s");
  EXPECT_THROW((void)scale::Ut1::minus_utc(not_a_number * si::second), BadInput);
  EXPECT_THROW((void)scale::Ut1::minus_tai(infinity * si::second), BadInput);
}

// In every scale: a modified Julian date for a Julian date, and the reverse, are thousands of years off.
TEST(TimeScale, ModifiedAndJulianDatesAreNotTakenForEachOther) {
  const std::string julian =
      ": Julian dates are of the years 0 to 9999, 1721059.5 or more; for a modified one, "
      "from_modified_julian_date";
  const std::string modified =
      ": modified Julian dates are of the years 0 to 6570, less than 1721059; for a Julian date, "
      "from_julian_date";
  const auto as_julian = [](const TimeScale& in, double number, double fraction) {
    return complaint([&] { Epoch::from_julian_date(in, number, fraction); });
  };
  const auto as_modified = [](const TimeScale& in, double number, double fraction) {
    return complaint([&] { Epoch::from_modified_julian_date(in, number, fraction); });
  };
  for (const TimeScale& in :
       {TimeScale{scale::utc}, TimeScale{scale::tai}, TimeScale{scale::tt}, TimeScale{scale::tdb},
        TimeScale{scale::gps}, TimeScale{scale::Ut1::minus_tai(-37.1 * si::second)},
        TimeScale{scale::Ut1::minus_utc(-0.1 * si::second)}}) {
    const std::string name = in.name();
    EXPECT_EQ(as_julian(in, 59683.0, 0.25), "Julian date 59683 + 0.25 in " + name + julian);
    EXPECT_EQ(as_julian(in, 0.25, 59683.0), "Julian date 0.25 + 59683 in " + name + julian);
    EXPECT_EQ(as_modified(in, 2459683.5, 0.25),
              "modified Julian date 2459683.5 + 0.25 in " + name + modified);
    for (const double far : {-1e300, -1e12, 5373484.5, 1e12, 1e300}) {
      EXPECT_EQ(as_julian(in, far, 0.0), "Julian date " + detail::text(far) + " + 0 in " + name + julian);
      EXPECT_NE(as_modified(in, far, 0.0).find(modified), std::string::npos) << far << name;
    }
    EXPECT_EQ(as_julian(in, 2459683.5, 0.25), as_modified(in, 59683.0, 0.25)) << name;
  }
  EXPECT_EQ(complaint([] {
              Epoch::from_julian_date(JulianDate<scale::Tt>{59683.0, 0.25});
            }),
            "Julian date 59683 + 0.25 in TT" + julian);
  EXPECT_EQ(complaint([] { Epoch::from_utc_mjd(2459683, 0.25); }),
            "Epoch::from_utc_mjd(2459683, 0.25)" + modified);
  // The first and the last of both, in the calendar.
  EXPECT_EQ(Epoch::from_julian_date(scale::tt, 1721059.5).tt(0), "0000-01-01T00:00:00");
  EXPECT_EQ(Epoch::from_julian_date(scale::tt, 5373483.5, 0.5).tt(0), "9999-12-31T12:00:00");
  EXPECT_EQ(Epoch::from_modified_julian_date(scale::tt, -678941.0).tt(0), "0000-01-01T00:00:00");
  EXPECT_EQ(Epoch::from_modified_julian_date(scale::tt, 1721058.0).tt(0).substr(0, 5), "6570-");
}

// A text that names its scale is read in it, and in no other.
TEST(TimeScale, TextsThatNameTheirScale) {
  const std::string accepted = complaint([] {});
  for (const char* name : {"UTC", "TAI", "TT", "TDB", "GPS"}) {
    const auto text = [&](const char* of) { return std::string{"2022-104T10:22:11.25 "} + of; };
    const auto in = [&](const TimeScale& scale) {
      return complaint([&] { Epoch::from(scale, text(name)); });
    };
    EXPECT_EQ(in(scale::utc) == accepted, std::string{"UTC"} == name) << name;
    EXPECT_EQ(in(scale::tdb) == accepted, std::string{"TDB"} == name) << name;
  }
  EXPECT_EQ(Epoch::from("2022-04-14T10:22:11.25 GPS"), Epoch::from(scale::gps, "2022-04-14T10:22:11.25"));
  EXPECT_EQ(Epoch::from("2022-04-14T10:22:11.25 TT"), Epoch::from_tt("2022-04-14T10:22:11.25"));
  std::ostringstream written;
  const auto t = Epoch::from_utc("2016-12-31T23:59:60.5");
  written << t;
  EXPECT_EQ(Epoch::from(written.str()), t);
  EXPECT_EQ(complaint([] { Epoch::from("2022-04-14T10:22:11.25"); }),
            "epoch '2022-04-14T10:22:11.25': it does not end with its scale, UTC, TAI, TT, TDB or GPS; UT1 "
            "needs UT1-TAI");
  EXPECT_EQ(complaint([] { Epoch::from_utc("2022-04-14T10:22:11 TT"); }),
            "epoch '2022-04-14T10:22:11 TT' in UTC: it is not written as 2022-04-14T10:22:11.874999");
  EXPECT_EQ(Epoch::from("2022-04-14T10:22:11.25Z"), Epoch::from_utc("2022-04-14T10:22:11.25"));
  EXPECT_THROW(Epoch::from("TT"), BadInput);
  EXPECT_THROW(Epoch::from("Z UTC"), BadInput);
}

// A date has its scale in its type: the way back takes no other.
TEST(TimeScale, EpochOfATypedDate) {
  const auto t = Epoch::from_utc("2022-04-14T10:22:11.25");
  EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(scale::utc)), t), clock_rounding);
  EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(scale::tt)), t), clock_rounding);
  EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(scale::tdb)), t), clock_rounding);
  EXPECT_LE(apart(Epoch::from_julian_date(t.julian_date(scale::gps)), t), clock_rounding);
  EXPECT_EQ(Epoch::from_julian_date(t.tai()), t);
  EXPECT_EQ(Epoch::from_julian_date(JulianDate<scale::Tt>{2451545.0, 0.0}),
            Epoch::from_tt("2000-01-01T12:00:00"));
}

template <class A, class B>
concept Compares = requires(const A& a, const B& b) {
  a < b;
};
template <class A, class B>
concept Equates = requires(const A& a, const B& b) {
  a == b;
};
template <class A, class B>
concept Subtracts = requires(const A& a, const B& b) {
  a - b;
};
template <class Scale, class Text>
concept Reads = requires(const Scale& scale, const Text& text) {
  Epoch::from(scale, text);
};
template <class Scale>
concept HasDate = requires(const Epoch& t, const Scale& scale) {
  t.julian_date(scale);
};
template <class A, class B>
concept ComparesInAWay = requires(const A& a, const B& b) {
  a < b;
}
|| requires(const A& a, const B& b) {
  a > b;
}
|| requires(const A& a, const B& b) {
  a <= b;
}
|| requires(const A& a, const B& b) {
  a >= b;
};
using Tt = JulianDate<scale::Tt>;
using Utc = JulianDate<scale::Utc>;

static_assert(Compares<Tt, Tt> && Equates<Tt, Tt> && Subtracts<Epoch, Epoch>);
static_assert(Tt{2451545.5, 0.25} > Tt{2451544.5, 0.75} && Tt{2451544.5, 0.25} <= Tt{2451544.5, 0.25});
static_assert(Tt{2451544.5, 0.5} >= Tt{2451544.5, 0.25} && !(Tt{2451544.5, 0.5} <= Tt{2451544.5, 0.25}));
static_assert(!ComparesInAWay<Tt, Utc> && !ComparesInAWay<Tt, Epoch> && !ComparesInAWay<Tt, double>);
static_assert(!Compares<Tt, Utc> && !Equates<Tt, Utc> && !Compares<Epoch, Tt> && !Compares<Tt, Epoch>);
static_assert(!Equates<Epoch, Tt> && !Equates<Tt, Epoch> && !Equates<Tt, double> && !Compares<Tt, double>);
static_assert(!Subtracts<Tt, Tt> && !Subtracts<Tt, Utc> && !Subtracts<Epoch, Tt> && !Subtracts<Tt, Epoch>);
static_assert(!Compares<GpsTime, Epoch> && !Subtracts<GpsTime, GpsTime> && !Equates<GpsTime, Epoch>);
static_assert(!ComparesInAWay<JulianDate<scale::Ut1>, JulianDate<scale::Ut1>> &&
              !Equates<JulianDate<scale::Ut1>, JulianDate<scale::Ut1>>);
static_assert(Reads<scale::Tt, DateText<scale::Tt>> && !Reads<scale::Tt, DateText<scale::Utc>>);
static_assert(Reads<scale::Tt, std::string> &&
              Reads<TimeScale, DateText<scale::Utc>>);      // known at run time only
static_assert(HasDate<scale::Ut1> && !HasDate<TimeScale>);  // the scale stays in the type of the date

}  // namespace
}  // namespace vectrix::time_scale_test
