#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <ostream>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {
namespace {

constexpr double modified_julian_zero = 2400000.5;
constexpr int first_utc_day = 36934;  // 1960 January 1, modified Julian

// Splits the date into a day that ends in .5 and a fraction in [0, 1).
JulianDate normalised(double day, double fraction) {
  const double midnight = std::floor(day - 0.5) + 0.5;
  fraction += day - midnight;
  const double carry = std::floor(fraction);
  const JulianDate date{midnight + carry, fraction - carry};
  // A fraction just below 0 rounds up to 1.
  return date.fraction < 1.0 ? date : JulianDate{date.day + 1.0, 0.0};
}

struct CalendarTime {
  int year, month, day, hour, minute;
  double second;
};

[[noreturn]] void refuse(const char* scale, std::string_view text, const std::string& reason) {
  throw BadInput("epoch '" + std::string{text} + "' in " + scale + ": " + reason);
}

// True if the text matches the pattern: a digit for each 'd', else the same character.
bool matches(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    if (pattern[i] == 'd' ? !digit : text[i] != pattern[i]) return false;
  }
  return true;
}

std::optional<CalendarTime> parsed(std::string_view text) {
  constexpr std::size_t whole = 19;
  if (!matches(text.substr(0, whole), "dddd-dd-ddTdd:dd:dd")) return std::nullopt;
  if (text.size() > whole) {
    const std::string_view decimals = text.substr(whole);
    constexpr std::string_view most = ".dddddddddddd";
    if (decimals.size() < 2 || !matches(decimals, most.substr(0, decimals.size()))) return std::nullopt;
  }
  const auto number = [&](std::size_t at, std::size_t length, auto value) {
    std::from_chars(text.data() + at, text.data() + at + length, value);
    return value;
  };
  return CalendarTime{number(0, 4, 0),  number(5, 2, 0),  number(8, 2, 0),
                      number(11, 2, 0), number(14, 2, 0), number(17, text.size() - 17, 0.0)};
}

// The Julian date in ERFA's form for the text in the scale "UTC" or "TT".
JulianDate calendar_date(const char* scale, std::string_view text, std::string_view body) {
  const auto time = parsed(body);
  if (!time) refuse(scale, text, "it is not written as 2022-04-14T10:22:11.874999");
  double day = 0.0;
  double fraction = 0.0;
  const int status = eraDtf2d(scale, time->year, time->month, time->day, time->hour, time->minute,
                              time->second, &day, &fraction);
  constexpr std::array<const char*, 6> wrong{"year", "month", "day", "hour", "minute", "second"};
  if (status < 0)
    refuse(scale, text, std::string{"there is no such "} + wrong.at(static_cast<std::size_t>(-status - 1)));
  if (status >= 2) refuse(scale, text, "there is no such second");
  return {day, fraction};
}

void require_utc(int status, const std::string& what) {
  if (status < 0) throw BadInput(what + " is not a date that ERFA can take to or from UTC");
}

struct Calendar {
  int year = 0, month = 0, day = 0;
};
Calendar calendar_of(const JulianDate& date) {
  Calendar found;
  double fraction = 0.0;
  if (eraJd2cal(date.day, date.fraction, &found.year, &found.month, &found.day, &fraction) < 0) {
    throw BadInput("Epoch: the Julian date " + detail::text(date.day) + " is outside the calendar");
  }
  return found;
}

// TAI - UTC, s, on a day of UTC, as ERFA's quasi-Julian date.
double seconds_of_tai_minus_utc(const JulianDate& utc) {
  const JulianDate date = normalised(utc.day, utc.fraction);
  const Calendar on = calendar_of({date.day, 0.0});
  double seconds = 0.0;
  eraDat(on.year, on.month, on.day, date.fraction, &seconds);
  return seconds;
}

// The time on a day of this length, s: the last minute has what the day has more or less. What rounds up to
// the end of the day is the next one.
std::string day_text(const JulianDate& date, double length, int decimals) {
  if (decimals < 0 || decimals > 9) {
    throw BadInput("Epoch: asked for " + detail::text(decimals) + " decimals; there can be 0 to 9");
  }
  const JulianDate at = normalised(date.day, date.fraction);
  const double unit = std::pow(10.0, decimals);
  const auto rounded = std::llround(at.fraction * length * unit);
  constexpr double rounding = 0.03;  // of the last digit, of which a day has 10^14
  const bool is_next = static_cast<double>(rounded) > length * unit - rounding;
  const Calendar on = calendar_of({is_next ? at.day + 1.0 : at.day, 0.0});
  const auto ticks = is_next ? 0 : rounded;
  const auto per_second = std::llround(unit);
  const auto second = ticks / per_second;
  const auto hour = std::min(second / 3600, 23LL);
  const auto minute = std::min(second / 60 - 60 * hour, 59LL);
  std::array<char, 96> buffer{};
  int size = std::snprintf(buffer.data(), buffer.size(), "%04d-%02d-%02dT%02lld:%02lld:%02lld", on.year,
                           on.month, on.day, hour, minute, second - 3600 * hour - 60 * minute);
  if (decimals > 0) {
    const auto used = static_cast<std::size_t>(size);
    size +=
        std::snprintf(buffer.data() + used, buffer.size() - used, ".%0*lld", decimals, ticks % per_second);
  }
  return {buffer.data(), static_cast<std::size_t>(size)};
}

// In TAI and TT.
std::string iso_text(const JulianDate& date, int decimals) {
  return day_text(date, ERFA_DAYSEC, decimals);
}

// ERFA's quasi-Julian date stretches a day that ends in a step to 1. Its eraD2dtf takes this back for leap
// seconds, but not for the steps of 0.05 and 0.1 s before 1972.
std::string utc_text(const JulianDate& utc, int decimals) {
  const double midnight = normalised(utc.day, utc.fraction).day;
  const double at_midnight = seconds_of_tai_minus_utc({midnight, 0.0});
  const double drift = 2.0 * (seconds_of_tai_minus_utc({midnight, 0.5}) - at_midnight);
  const double step = seconds_of_tai_minus_utc({midnight + 1.0, 0.0}) - at_midnight - drift;
  return day_text(utc, ERFA_DAYSEC + step, decimals);
}

JulianDate tai_of_utc(const JulianDate& utc, const std::string& what) {
  double day = 0.0;
  double fraction = 0.0;
  require_utc(eraUtctai(utc.day, utc.fraction, &day, &fraction), what);
  return normalised(day, fraction);
}

bool before_utc(const JulianDate& tai) {
  return tai < tai_of_utc({modified_julian_zero + first_utc_day, 0.0}, "the first day of UTC");
}

// UTC, as ERFA's quasi-Julian date, in which every day has the length 1.
JulianDate utc_date(const JulianDate& tai) {
  if (before_utc(tai)) {
    throw BadInput("Epoch " + iso_text(tai, 6) + " TAI: UTC is not known before 1960");
  }
  double day = 0.0;
  double fraction = 0.0;
  require_utc(eraTaiutc(tai.day, tai.fraction, &day, &fraction), "Epoch " + iso_text(tai, 6) + " TAI");
  return {day, fraction};
}

}  // namespace

Epoch Epoch::from_utc(std::string_view text) {
  const std::string_view body = text.ends_with('Z') ? text.substr(0, text.size() - 1) : text;
  const JulianDate utc = calendar_date("UTC", text, body);
  if (body < "1960") refuse("UTC", text, "UTC is not known before 1960");
  return Epoch{tai_of_utc(utc, "epoch '" + std::string{text} + "'")};
}

Epoch Epoch::from_tt(std::string_view text) {
  const JulianDate tt = calendar_date("TT", text, text);
  double day = 0.0;
  double fraction = 0.0;
  eraTttai(tt.day, tt.fraction, &day, &fraction);  // always succeeds
  return Epoch{normalised(day, fraction)};
}

Epoch Epoch::from_utc_mjd(int day, double part) {
  const std::string what = "Epoch::from_utc_mjd(" + detail::text(day) + ", " + detail::text(part) + ")";
  if (!(part >= 0.0 && part < 1.0)) throw BadInput(what + ": the part of the day is outside [0, 1)");
  if (day < first_utc_day) throw BadInput(what + ": UTC is not known before 1960");
  return Epoch{tai_of_utc({modified_julian_zero + day, part}, what)};
}

std::string Epoch::utc(int decimals) const {
  return utc_text(utc_date(tai_), decimals);
}

std::string Epoch::tt(int decimals) const {
  return iso_text(tt_date(), decimals);
}

JulianDate Epoch::tt_date() const {
  double day = 0.0;
  double fraction = 0.0;
  eraTaitt(tai_.day, tai_.fraction, &day, &fraction);  // always succeeds
  return normalised(day, fraction);
}

Quantity<si::time> Epoch::tai_minus_utc() const {
  return seconds_of_tai_minus_utc(utc_date(tai_)) * si::second;
}

Quantity<si::time> operator-(const Epoch& end, const Epoch& start) {
  return ((end.tai().day - start.tai().day) * ERFA_DAYSEC +
          (end.tai().fraction - start.tai().fraction) * ERFA_DAYSEC) *
         si::second;
}

Epoch operator+(const Epoch& epoch, const Quantity<si::time>& duration) {
  const double seconds = duration.value();
  if (!std::isfinite(seconds)) {
    throw BadInput("epoch + duration: the duration is " + detail::text(seconds) + " s");
  }
  const double days = std::floor(seconds / ERFA_DAYSEC);
  const double rest = std::fma(-days, ERFA_DAYSEC, seconds) / ERFA_DAYSEC;
  return Epoch{normalised(epoch.tai_.day + days, epoch.tai_.fraction + rest)};
}

Epoch operator-(const Epoch& epoch, const Quantity<si::time>& duration) {
  return epoch + (-duration);
}

std::ostream& operator<<(std::ostream& out, const Epoch& epoch) {
  return before_utc(epoch.tai()) ? out << epoch.tt() << " TT" : out << epoch.utc() << " UTC";
}

}  // namespace vectrix
