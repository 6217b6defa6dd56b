#include <erfa.h>
#include <erfaextra.h>
#include <erfam.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <vectrix/frames/errors.hpp>

#include "date.hpp"

namespace vectrix {
namespace detail {
namespace {

constexpr double modified_julian_zero = 2400000.5;
constexpr double first_utc_day = 36934.0;  // 1960 January 1, modified Julian
constexpr double first_gps_day = 44244.0;  // 1980 January 6
constexpr double gps_minus_tai = -19.0;    // s
constexpr double below_one = 1.0 - std::numeric_limits<double>::epsilon() / 2;

Date shifted(const Date& date, double seconds) {
  return normalised(date.day, date.fraction + seconds / ERFA_DAYSEC);
}

std::string tai_text(const Date& tai) {
  return "Epoch " +
         calendar_text(tai.day, tai.fraction * ERFA_DAYSEC, ERFA_DAYSEC, DayStyle::month_and_day, 6) + " TAI";
}

Date tai_of_utc(const Date& utc, const std::string& what) {
  require_known_utc(utc, what);
  return tai_of(utc_day(utc.day), utc.fraction);
}

// TAI - UTC, s. The part of the day is of 86400 s.
double table_of_erfa(double day, double part) {
  const Calendar on = calendar_of(day);
  double seconds = 0.0;
  eraDat(on.year, on.month, on.day, part, &seconds);
  return seconds;
}

// Also what the clock's rounding may put into it: UT1 - (UT1-UTC) is read as the second after it.
constexpr double clock_rounding = 1e-10;  // s

bool in_leap_second(const UtcTime& utc) {
  return utc.day.step > 0.0 && utc.second() > ERFA_DAYSEC - clock_rounding;
}

// The year of the release of ERFA: eraDat doubts dates more than five years later.
int erfa_release() {
  constexpr int trusted = 5, last_row = 2017, far = 2100;
  double seconds = 0.0;
  int year = last_row;
  while (year < far && eraDat(year + trusted + 1, 1, 1, 0.0, &seconds) == 0) ++year;
  return year;
}

// The table has all leap seconds until its last one, and until the release of ERFA.
bool leap_seconds_are_known(const UtcDay& utc) {
  static const int release = erfa_release();
  eraLEAPSECOND* rows = nullptr;
  const int count = eraGetLeapSeconds(&rows);
  const eraLEAPSECOND& last = rows[count - 1];
  const Calendar on = calendar_of(utc.day);
  return on.year < release || 12 * on.year + on.month < 12 * last.iyear + last.month;
}

// TDB - TT, s, at the centre of the Earth. The date may be in either.
double tdb_minus_tt(const Date& date) {
  return eraDtdb(date.day, date.fraction, 0.0, 0.0, 0.0, 0.0);
}

}  // namespace

void require_known_utc(const Date& utc, const std::string& what) {
  if (utc.modified_day() < first_utc_day) throw BadInput(what + ": UTC is not known before 1960");
}

// Each part is split by itself: both splits are exact, so that only the sum of two fractions is rounded.
Date normalised(double day, double fraction) {
  const double midnight = std::floor(day - 0.5) + 0.5;
  const double whole = std::floor(fraction);
  const double rest = (day - midnight) + (fraction - whole);
  const double carry = std::floor(rest);
  const Date date{midnight + whole + carry, rest - carry};
  // A fraction just below 0 rounds up to 1.
  return date.fraction < 1.0 ? date : Date{date.day + 1.0, 0.0};
}

Date tai_of(const TimeScale& scale, const Date& date, const std::string& what) {
  const double ut1_offset = scale.ut1_offset().value();
  switch (scale.kind()) {
    case TimeScale::Kind::utc:
      return tai_of_utc(date, what);
    case TimeScale::Kind::tai:
      return date;
    case TimeScale::Kind::tt:
      return shifted(date, -ERFA_TTMTAI);
    case TimeScale::Kind::tdb:
      return shifted(date, -tdb_minus_tt(date) - ERFA_TTMTAI);
    case TimeScale::Kind::gps:
      if (date.modified_day() < first_gps_day) throw BadInput(what + ": GPS time begins in 1980");
      return shifted(date, -gps_minus_tai);
    case TimeScale::Kind::ut1_by_tai: {
      const Date tai = shifted(date, -ut1_offset);
      if (const auto fault = ut1_fault(tai, ut1_offset); !fault.empty()) throw BadInput(what + ": " + fault);
      return tai;
    }
    case TimeScale::Kind::ut1_by_utc:
      break;
  }
  Date utc = shifted(date, -ut1_offset);
  if ((1.0 - utc.fraction) * ERFA_DAYSEC < clock_rounding && utc_day(utc.day).step != 0.0)
    utc = {utc.day + 1.0, 0.0};
  require_known_utc(utc, what);
  return shifted(utc, table_of_erfa(utc.day, utc.fraction));
}

bool has_whole_day(const TimeScale& scale, double day) {
  if (scale.kind() == TimeScale::Kind::gps) return day - modified_julian_zero >= first_gps_day;
  return scale.kind() != TimeScale::Kind::ut1_by_tai && scale.kind() != TimeScale::Kind::ut1_by_utc;
}

Date date_of(const TimeScale& scale, const Date& tai) {
  const double ut1_offset = scale.ut1_offset().value();
  switch (scale.kind()) {
    case TimeScale::Kind::utc: {
      const UtcTime utc = utc_time(tai);
      return {utc.day.day, std::min(utc.fraction, below_one)};
    }
    case TimeScale::Kind::tai:
      return tai;
    case TimeScale::Kind::tt:
      return shifted(tai, ERFA_TTMTAI);
    case TimeScale::Kind::tdb:
      return shifted(tai, ERFA_TTMTAI + tdb_minus_tt(shifted(tai, ERFA_TTMTAI)));
    case TimeScale::Kind::gps: {
      const Date gps = shifted(tai, gps_minus_tai);
      if (gps.modified_day() < first_gps_day) throw BadInput(tai_text(tai) + ": GPS time begins in 1980");
      return gps;
    }
    case TimeScale::Kind::ut1_by_tai:
      if (const auto fault = ut1_fault(tai, ut1_offset); !fault.empty())
        throw BadInput(tai_text(tai) + ": " + fault);
      return shifted(tai, ut1_offset);
    case TimeScale::Kind::ut1_by_utc:
      break;
  }
  const UtcTime utc = utc_time(tai);
  if (in_leap_second(utc))
    throw BadInput(tai_text(tai) + ": UT1-UTC names no instant of a leap second; take Ut1::minus_tai");
  return shifted(tai, ut1_offset - utc.tai_minus_utc());
}

bool before_utc(const Date& tai) {
  static const Date first = tai_of_utc({modified_julian_zero + first_utc_day, 0.0}, "the first day of UTC");
  return tai < first;
}

std::string ut1_fault(const Date& tai, double ut1_minus_tai, Ut1Kept kept) {
  static const Date leap_seconds_begin = tai_of_utc({2441317.5, 0.0}, "1972 January 1");
  constexpr double over_a_leap_second = 1.1, over_many = 5.0;  // s
  constexpr double rounding = 1e-13;                           // s, of differences of up to 100 s
  if (tai < leap_seconds_begin) return {};
  const UtcTime utc = utc_time(tai);
  const double ut1_minus_utc = ut1_minus_tai + utc.tai_minus_utc();
  const bool is_wide = kept == Ut1Kept::for_years || !leap_seconds_are_known(utc.day);
  const double largest = is_wide                               ? over_many
                         : kept == Ut1Kept::over_a_leap_second ? over_a_leap_second
                                                               : largest_ut1_minus_utc;
  if (std::abs(ut1_minus_utc) <= largest + rounding) return {};
  return "UT1-TAI is " + text(ut1_minus_tai) + " s, so UT1-UTC " + text(ut1_minus_utc) +
         " s; it must be within " + text(largest) + " s (UTC keeps it below 0.9 s" +
         (is_wide ? ", leap seconds may be missing" : "") + "); UT1-TAI = (UT1-UTC) - (TAI-UTC)";
}

// ERFA's quasi-Julian date stretches a day that ends in a step to 1. Its eraD2dtf takes this back for leap
// seconds, but not for the steps of 0.05 and 0.1 s before 1972.
double UtcDay::quasi_length() const {
  return ERFA_DAYSEC + step;
}

double UtcDay::length() const {
  return ERFA_DAYSEC + step * (ERFA_DAYSEC / (ERFA_DAYSEC + drift));
}

UtcDay utc_day(double day) {
  constexpr double rounding = 1e-9;  // s: the smallest step is 0.005 s
  const double at_midnight = table_of_erfa(day, 0.0);
  const double drift = 2.0 * (table_of_erfa(day, 0.5) - at_midnight);
  const double step = table_of_erfa(day + 1.0, 0.0) - (at_midnight + drift);
  return {day, at_midnight, drift, std::abs(step) > rounding ? step : 0.0};
}

// As eraUtctai, to the last bit.
Date tai_of(const UtcDay& utc, double fraction) {
  fraction *= utc.quasi_length() / ERFA_DAYSEC;
  fraction *= (ERFA_DAYSEC + utc.drift) / ERFA_DAYSEC;
  fraction += utc.tai_minus_utc / ERFA_DAYSEC;
  // The day is whole, and the fraction nearly always in it: then normalised() would change nothing.
  return fraction >= 0.0 && fraction < 1.0 ? Date{utc.day, fraction} : normalised(utc.day, fraction);
}

double UtcTime::second() const {
  return fraction * day.quasi_length();
}

double UtcTime::tai_minus_utc() const {
  return day.tai_minus_utc + day.drift * (second() / ERFA_DAYSEC);
}

// Not eraTaiutc: at a step before 1972 it takes up to 3 ns after midnight for the day before.
UtcTime utc_time(const Date& tai) {
  if (before_utc(tai)) throw BadInput(tai_text(tai) + ": UTC is not known before 1960");
  UtcDay utc = utc_day(tai.day);  // TAI is ahead of UTC, by less than a day
  if (tai < tai_of(utc, 0.0)) utc = utc_day(tai.day - 1.0);
  double fraction = (tai.day - utc.day) + (tai.fraction - utc.tai_minus_utc / ERFA_DAYSEC);
  fraction *= ERFA_DAYSEC / (ERFA_DAYSEC + utc.drift);
  fraction *= ERFA_DAYSEC / utc.quasi_length();
  return {utc, std::max(fraction, 0.0)};
}

const TimeScale* scale_named(std::string_view name) {
  static constexpr const TimeScale* scales[] = {&scale::utc, &scale::tai, &scale::tt, &scale::tdb,
                                                &scale::gps};
  for (const TimeScale* scale : scales) {
    if (name == scale->name()) return scale;
  }
  return nullptr;
}

}  // namespace detail

namespace scale {

Ut1 Ut1::minus_tai(const Quantity<si::time>& difference) {
  if (!std::isfinite(difference.value())) {
    throw BadInput("Ut1::minus_tai: UT1-TAI is " + detail::text(difference.value()) + " s");
  }
  return Ut1{Kind::ut1_by_tai, difference};
}

Ut1 Ut1::minus_utc(const Quantity<si::time>& difference) {
  if (!(std::abs(difference.value()) <= detail::largest_ut1_minus_utc)) {
    throw BadInput("Ut1::minus_utc: UT1-UTC is " + detail::text(difference.value()) +
                   " s; UTC keeps it within 0.9 s");
  }
  return Ut1{Kind::ut1_by_utc, difference};
}

}  // namespace scale
}  // namespace vectrix
