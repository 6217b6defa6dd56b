#include <erfa.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include <vectrix/frames/errors.hpp>

#include "date.hpp"

namespace vectrix::detail {
namespace {

struct Calendar {
  int year = 0, month = 0, day = 0;
};
struct CalendarTime {
  Calendar on;  // without a month, the day of the year
  int hour, minute;
  double second;
};

[[noreturn]] void refuse(const TimeScale& scale, std::string_view text, const std::string& reason) {
  throw BadInput("epoch '" + std::string{text} + "' in " + scale.name() + ": " + reason);
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
  constexpr std::string_view with_month = "dddd-dd-ddTdd:dd:dd";
  constexpr std::string_view with_day_of_year = "dddd-dddTdd:dd:dd";
  const bool has_month = matches(text.substr(0, with_month.size()), with_month);
  const std::size_t whole = has_month ? with_month.size() : with_day_of_year.size();
  if (!has_month && !matches(text.substr(0, whole), with_day_of_year)) return std::nullopt;
  if (text.size() > whole) {
    const std::string_view decimals = text.substr(whole);
    constexpr std::string_view most = ".dddddddddddd";
    if (decimals.size() < 2 || !matches(decimals, most.substr(0, decimals.size()))) return std::nullopt;
  }
  const auto number = [&](std::size_t at, std::size_t length, auto value) {
    std::from_chars(text.data() + at, text.data() + at + length, value);
    return value;
  };
  const Calendar on = has_month ? Calendar{number(0, 4, 0), number(5, 2, 0), number(8, 2, 0)}
                                : Calendar{number(0, 4, 0), 0, number(5, 3, 0)};
  return CalendarTime{on, number(whole - 8, 2, 0), number(whole - 5, 2, 0),
                      number(whole - 2, text.size() - whole + 2, 0.0)};
}

double first_day_of(int year) {
  double zero = 0.0;
  double modified = 0.0;
  eraCal2jd(year, 1, 1, &zero, &modified);
  return zero + modified;
}

Calendar calendar_of(double julian_day) {
  Calendar found;
  double fraction = 0.0;
  if (eraJd2cal(julian_day, 0.0, &found.year, &found.month, &found.day, &fraction) < 0) {
    throw BadInput("Epoch: the Julian date " + text(julian_day) + " is outside the calendar");
  }
  return found;
}

std::string day_text(double julian_day, DayStyle style) {
  const Calendar on = calendar_of(julian_day);
  std::array<char, 64> buffer{};
  if (style == DayStyle::month_and_day) {
    std::snprintf(buffer.data(), buffer.size(), "%04d-%02d-%02d", on.year, on.month, on.day);
  } else {
    const int day_of_year = static_cast<int>(julian_day - first_day_of(on.year)) + 1;
    std::snprintf(buffer.data(), buffer.size(), "%04d-%03d", on.year, day_of_year);
  }
  return buffer.data();
}

}  // namespace

Date read_calendar(const TimeScale& scale, std::string_view text) {
  const bool in_utc = scale.kind() == TimeScale::Kind::utc;
  const std::string end = std::string{" "} + scale.name();
  std::string_view digits = text;
  if (text.ends_with(end)) {
    digits.remove_suffix(end.size());
  } else if (in_utc && text.ends_with('Z')) {
    digits.remove_suffix(1);
  }
  const auto time = parsed(digits);
  if (!time) refuse(scale, text, "it is not written as 2022-04-14T10:22:11.874999");
  Calendar on = time->on;
  if (text[7] != '-') {
    const int days = static_cast<int>(first_day_of(on.year + 1) - first_day_of(on.year));
    if (on.day < 1 || on.day > days) refuse(scale, text, "there is no such day");
    on = calendar_of(first_day_of(on.year) + on.day - 1);
  }
  double day = 0.0;
  double fraction = 0.0;
  const int status = eraDtf2d(in_utc ? "UTC" : "TAI", on.year, on.month, on.day, time->hour, time->minute,
                              time->second, &day, &fraction);
  constexpr std::array<const char*, 6> wrong{"year", "month", "day", "hour", "minute", "second"};
  if (status < 0)
    refuse(scale, text, std::string{"there is no such "} + wrong.at(static_cast<std::size_t>(-status - 1)));
  if (status >= 2) refuse(scale, text, "there is no such second");
  return normalised(day, fraction);
}

// The last minute has what the day has more or less. What rounds up to the end of the day is the next one.
std::string calendar_text(const Date& date, double day_length, DayStyle style, int decimals) {
  if (decimals < 0 || decimals > 9) {
    throw BadInput("Epoch: asked for " + text(decimals) + " decimals; there can be 0 to 9");
  }
  const double unit = std::pow(10.0, decimals);
  const auto rounded = std::llround(date.fraction * day_length * unit);
  constexpr double rounding = 0.03;  // of the last digit, of which a day has 10^14
  const bool is_next = static_cast<double>(rounded) > day_length * unit - rounding;
  const auto ticks = is_next ? 0 : rounded;
  const auto per_second = std::llround(unit);
  const auto second = ticks / per_second;
  const auto hour = std::min(second / 3600, 23LL);
  const auto minute = std::min(second / 60 - 60 * hour, 59LL);
  std::array<char, 96> buffer{};
  const int size = std::snprintf(buffer.data(), buffer.size(), "T%02lld:%02lld:%02lld", hour, minute,
                                 second - 3600 * hour - 60 * minute);
  if (decimals > 0) {
    const auto used = static_cast<std::size_t>(size);
    std::snprintf(buffer.data() + used, buffer.size() - used, ".%0*lld", decimals, ticks % per_second);
  }
  return day_text(is_next ? date.day + 1.0 : date.day, style) + buffer.data();
}

}  // namespace vectrix::detail
