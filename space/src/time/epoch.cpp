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

// The second of the day and, of a UTC day that ends in a step, its length. ERFA's quasi-Julian date stretches
// such a day to 1 whatever the step; its eraD2dtf takes this back for leap seconds, not for the steps of 0.05
// and 0.1 s of 1961 to 1971.
struct SteppedDay {
  double second, length;
  JulianDate midnight, next;
};
std::optional<SteppedDay> stepped_day(const JulianDate& utc) {
  const JulianDate date = normalised(utc.day, utc.fraction);
  const auto tai_minus_utc = [](double midnight, double part) {
    int year = 0, month = 0, day = 0;
    double none = 0.0, seconds = 0.0;
    eraJd2cal(midnight, 0.0, &year, &month, &day, &none);
    eraDat(year, month, day, part, &seconds);
    return seconds;
  };
  const double drift = 2.0 * (tai_minus_utc(date.day, 0.5) - tai_minus_utc(date.day, 0.0));
  const double step = tai_minus_utc(date.day + 1.0, 0.0) - tai_minus_utc(date.day, 0.0) - drift;
  constexpr double rounding = 1e-9;  // s
  if (std::abs(step) < rounding) return std::nullopt;
  const double length = ERFA_DAYSEC + step;
  return SteppedDay{date.fraction * length, length, {date.day, 0.0}, {date.day + 1.0, 0.0}};
}

std::string iso_text(const char* scale, const JulianDate& date, int decimals);

// The last minute of the day has the step. What rounds up to the end of the day is the next one.
std::string text_of(const SteppedDay& day, int decimals) {
  const double unit = std::pow(10.0, decimals);
  const auto ticks = std::llround(day.second * unit);
  constexpr double rounding = 0.03;  // of a tick, in 10^14 of them
  if (static_cast<double>(ticks) > day.length * unit - rounding) return iso_text("TT", day.next, decimals);
  const std::string midnight = iso_text("TT", day.midnight, 0);
  const auto per_second = std::llround(unit);
  const auto seconds = ticks / per_second;
  const auto hour = std::min(seconds / 3600, 23LL);
  const auto minute = std::min((seconds - 3600 * hour) / 60, 59LL);
  std::array<char, 96> buffer{};
  int length = std::snprintf(buffer.data(), buffer.size(), "%.11s%02lld:%02lld:%02lld", midnight.c_str(),
                             hour, minute, seconds - 3600 * hour - 60 * minute);
  if (decimals > 0) {
    const auto used = static_cast<std::size_t>(length);
    length +=
        std::snprintf(buffer.data() + used, buffer.size() - used, ".%0*lld", decimals, ticks % per_second);
  }
  return {buffer.data(), static_cast<std::size_t>(length)};
}

std::string iso_text(const char* scale, const JulianDate& date, int decimals) {
  if (decimals < 0 || decimals > 9) {
    throw BadInput("Epoch: asked for " + detail::text(decimals) + " decimals; there can be 0 to 9");
  }
  int year = 0;
  int month = 0;
  int day = 0;
  std::array<int, 4> time{};
  if (eraD2dtf(scale, decimals, date.day, date.fraction, &year, &month, &day, time.data()) < 0) {
    throw BadInput("Epoch: the Julian date " + detail::text(date.day) + " is outside the calendar");
  }
  std::array<char, 96> buffer{};
  int length = std::snprintf(buffer.data(), buffer.size(), "%04d-%02d-%02dT%02d:%02d:%02d", year, month, day,
                             time[0], time[1], time[2]);
  if (decimals > 0) {
    const auto used = static_cast<std::size_t>(length);
    length += std::snprintf(buffer.data() + used, buffer.size() - used, ".%0*d", decimals, time[3]);
  }
  return {buffer.data(), static_cast<std::size_t>(length)};
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
    throw BadInput("Epoch " + iso_text("TAI", tai, 6) + " TAI: UTC is not known before 1960");
  }
  double day = 0.0;
  double fraction = 0.0;
  require_utc(eraTaiutc(tai.day, tai.fraction, &day, &fraction), "Epoch " + iso_text("TAI", tai, 6) + " TAI");
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
  const JulianDate utc = utc_date(tai_);
  const auto stepped = stepped_day(utc);
  return stepped && decimals >= 0 && decimals <= 9 ? text_of(*stepped, decimals)
                                                   : iso_text("UTC", utc, decimals);
}

std::string Epoch::tt(int decimals) const {
  return iso_text("TT", tt_date(), decimals);
}

JulianDate Epoch::tt_date() const {
  double day = 0.0;
  double fraction = 0.0;
  eraTaitt(tai_.day, tai_.fraction, &day, &fraction);  // always succeeds
  return normalised(day, fraction);
}

Quantity<si::time> Epoch::tai_minus_utc() const {
  const JulianDate utc = utc_date(tai_);
  int year = 0;
  int month = 0;
  int day = 0;
  double fraction = 0.0;
  double seconds = 0.0;
  eraJd2cal(utc.day, utc.fraction, &year, &month, &day, &fraction);
  eraDat(year, month, day, fraction, &seconds);
  return seconds * si::second;
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
