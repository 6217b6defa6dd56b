#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>

#include <vectrix/frames/errors.hpp>

#include "date.hpp"

namespace vectrix::detail {
namespace {

constexpr std::string_view with_month = "dddd-dd-dd", with_day_of_year = "dddd-ddd";

// True if the text matches the pattern: a digit for each 'd', else the same character.
bool matches(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    if (pattern[i] == 'd' ? !digit : text[i] != pattern[i]) return false;
  }
  return true;
}

int digits_of(std::string_view text, std::size_t at, std::size_t count) {
  int value = 0;
  for (const char digit : text.substr(at, count)) value = 10 * value + (digit - '0');
  return value;
}

double first_day_of(int year) {
  double zero = 0.0;
  double modified = 0.0;
  eraCal2jd(year, 1, 1, &zero, &modified);
  return zero + modified;
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

Calendar calendar_of(double julian_day) {
  Calendar found;
  double fraction = 0.0;
  if (eraJd2cal(julian_day, 0.0, &found.year, &found.month, &found.day, &fraction) < 0) {
    throw BadInput("Epoch: the Julian date " + text(julian_day) + " is outside the calendar");
  }
  return found;
}

/// T10:22:11.874999 at the begin of a text, and where it ends.
struct EpochReader::TimeOfDay {
  int hour, minute;
  double second;
  const char* end;

  static std::optional<TimeOfDay> of(const char* at, const char* end);
};

std::optional<EpochReader::TimeOfDay> EpochReader::TimeOfDay::of(const char* at, const char* end) {
  constexpr std::ptrdiff_t whole = 9, most_decimals = 12;
  if (end - at < whole || at[0] != 'T' || at[3] != ':' || at[6] != ':') return std::nullopt;
  const auto digit = [](char c) { return static_cast<unsigned>(c - '0'); };
  for (const int i : {1, 2, 4, 5, 7, 8}) {
    if (digit(at[i]) > 9) return std::nullopt;
  }
  const auto two = [&](int i) { return static_cast<int>(10 * digit(at[i]) + digit(at[i + 1])); };
  // Fourteen digits are an exact number, and so is the power of ten: the second is rounded once.
  std::int64_t digits = two(7);
  double unit = 1.0;
  const char* behind = at + whole;
  if (behind != end && *behind == '.') {
    const char* const first = ++behind;
    for (; behind != end && digit(*behind) <= 9 && behind - first < most_decimals; ++behind) {
      digits = 10 * digits + digit(*behind);
      unit *= 10.0;
    }
    if (behind == first) return std::nullopt;
  }
  return TimeOfDay{two(1), two(4), static_cast<double>(digits) / unit, behind};
}

EpochReader::EpochReader(const TimeScale& scale) : scale_(scale), end_(std::string{" "} + scale.name()) {}

std::string EpochReader::what(std::string_view text) const {
  return "epoch '" + std::string{text} + "' in " + scale_.name();
}

void EpochReader::refuse(std::string_view text, const std::string& reason) const {
  throw BadInput(what(text) + ": " + reason);
}

void EpochReader::begin_day(std::string_view text, std::string_view day) {
  Calendar on{digits_of(day, 0, 4), 0, 0};
  if (day.size() == with_month.size()) {
    on.month = digits_of(day, 5, 2);
    on.day = digits_of(day, 8, 2);
  } else {
    const int number = digits_of(day, 5, 3);
    if (number < 1 || number > static_cast<int>(first_day_of(on.year + 1) - first_day_of(on.year)))
      refuse(text, "there is no such day");
    on = calendar_of(first_day_of(on.year) + number - 1);
  }
  double zero = 0.0, modified = 0.0;
  const int status = eraCal2jd(on.year, on.month, on.day, &zero, &modified);
  constexpr std::array<const char*, 3> wrong{"year", "month", "day"};
  if (status < 0)
    refuse(text, std::string{"there is no such "} + wrong.at(static_cast<std::size_t>(-status - 1)));
  const double julian_day = zero + modified;
  if (scale_.kind() == TimeScale::Kind::utc) {
    require_known_utc({julian_day, 0.0}, what(text));
    day_ = utc_day(julian_day);
    is_known_ = true;
  } else {
    day_ = {julian_day, 0.0, 0.0, 0.0};
    is_known_ = has_whole_day(scale_, julian_day);
  }
  on_ = day;
}

const char* EpochReader::fault(const TimeOfDay& time) const {
  if (time.hour > 23) return "there is no such hour";
  if (time.minute > 59) return "there is no such minute";
  const bool is_last = time.hour == 23 && time.minute == 59;
  const double more = is_last ? day_.length() - ERFA_DAYSEC : 0.0;
  return time.second >= 60.0 + more ? "there is no such second" : nullptr;
}

// Of the day that is kept.
Epoch EpochReader::epoch_at(const TimeOfDay& time, std::string_view text) const {
  const double seconds = 60 * (60 * time.hour + time.minute) + time.second;
  const double fraction = seconds / day_.quasi_length();
  const bool in_utc = scale_.kind() == TimeScale::Kind::utc;
  const Date tai = in_utc && seconds < day_.length() ? tai_of(day_, fraction)
                                                     : tai_of(scale_, normalised(day_.day, fraction),
                                                              is_known_ ? std::string{} : what(text));
  return Epoch{JulianDate<scale::Tai>{tai.day, tai.fraction}};
}

Epoch EpochReader::read(std::string_view text) {
  std::string_view rest = text;
  if (text.ends_with(end_)) {
    rest.remove_suffix(end_.size());
  } else if (scale_.kind() == TimeScale::Kind::utc && text.ends_with('Z')) {
    rest.remove_suffix(1);
  }
  const auto begins = [&](std::string_view pattern) {
    return matches(rest.substr(0, pattern.size()), pattern);
  };
  const std::size_t size = begins(with_month)         ? with_month.size()
                           : begins(with_day_of_year) ? with_day_of_year.size()
                                                      : 0;
  const char* const end = rest.data() + rest.size();
  const auto time = size > 0 ? TimeOfDay::of(rest.data() + size, end) : std::nullopt;
  if (!time || time->end != end) refuse(text, "it is not written as 2022-04-14T10:22:11.874999");
  if (const std::string_view day = rest.substr(0, size); day != on_) begin_day(text, day);
  if (const char* wrong = fault(*time)) refuse(text, wrong);
  return epoch_at(*time, text);
}

std::optional<EpochReader::Scanned> EpochReader::scan(const char* at, const char* end) const {
  const std::string_view text{at, static_cast<std::size_t>(end - at)};
  if (!is_known_ || !text.starts_with(on_)) return std::nullopt;
  const auto time = TimeOfDay::of(at + on_.size(), end);
  if (!time || fault(*time)) return std::nullopt;
  return Scanned{epoch_at(*time, text), time->end};
}

// The last minute has what the day has more or less. What rounds up to the end of the day is the next one,
// but at the end of the year 9999, behind which there is no text that is read.
std::string calendar_text(double day, double second_of_day, double day_length, DayStyle style, int decimals) {
  if (decimals < 0 || decimals > 9) {
    throw BadInput("Epoch: asked for " + text(decimals) + " decimals; there can be 0 to 9");
  }
  const double unit = std::pow(10.0, decimals);
  const auto rounded = std::llround(second_of_day * unit);
  constexpr double rounding = 0.03;       // of the last digit, of which a day has 10^14
  constexpr double last_day = 5373483.5;  // 9999 December 31
  const bool is_end = static_cast<double>(rounded) > day_length * unit - rounding;
  const bool is_next = is_end && day != last_day;
  const auto ticks = is_next ? 0 : is_end ? rounded - 1 : rounded;
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
  return day_text(is_next ? day + 1.0 : day, style) + buffer.data();
}

}  // namespace vectrix::detail
