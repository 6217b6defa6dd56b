#include <erfa.h>

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

/// The parts of a text.
struct EpochReader::Written {
  std::string_view day;
  bool has_month;
  int hour, minute;
  double second;

  static std::optional<Written> of(std::string_view text);
};

std::optional<EpochReader::Written> EpochReader::Written::of(std::string_view text) {
  constexpr std::string_view with_month = "dddd-dd-ddTdd:dd:dd";
  constexpr std::string_view with_day_of_year = "dddd-dddTdd:dd:dd";
  const bool has_month = matches(text.substr(0, with_month.size()), with_month);
  const std::size_t whole = has_month ? with_month.size() : with_day_of_year.size();
  if (!has_month && !matches(text.substr(0, whole), with_day_of_year)) return std::nullopt;
  std::string_view decimals = text.substr(whole);
  if (!decimals.empty()) {
    constexpr std::string_view most = ".dddddddddddd";
    if (decimals.size() < 2 || !matches(decimals, most.substr(0, decimals.size()))) return std::nullopt;
    decimals.remove_prefix(1);
  }
  // Fourteen digits are an exact number, and so is the power of ten: the second is rounded once.
  std::int64_t digits = digits_of(text, whole - 2, 2);
  double unit = 1.0;
  for (const char digit : decimals) {
    digits = 10 * digits + (digit - '0');
    unit *= 10.0;
  }
  return Written{text.substr(0, whole - 9), has_month, digits_of(text, whole - 8, 2),
                 digits_of(text, whole - 5, 2), static_cast<double>(digits) / unit};
}

EpochReader::EpochReader(const TimeScale& scale) : scale_(scale), end_(std::string{" "} + scale.name()) {}

std::string EpochReader::what(std::string_view text) const {
  return "epoch '" + std::string{text} + "' in " + scale_.name();
}

void EpochReader::refuse(std::string_view text, const std::string& reason) const {
  throw BadInput(what(text) + ": " + reason);
}

void EpochReader::begin_day(std::string_view text, const Written& written) {
  Calendar on{digits_of(written.day, 0, 4), 0, 0};
  if (written.has_month) {
    on.month = digits_of(written.day, 5, 2);
    on.day = digits_of(written.day, 8, 2);
  } else {
    const int day = digits_of(written.day, 5, 3);
    if (day < 1 || day > static_cast<int>(first_day_of(on.year + 1) - first_day_of(on.year)))
      refuse(text, "there is no such day");
    on = calendar_of(first_day_of(on.year) + day - 1);
  }
  double zero = 0.0, modified = 0.0;
  const int status = eraCal2jd(on.year, on.month, on.day, &zero, &modified);
  constexpr std::array<const char*, 3> wrong{"year", "month", "day"};
  if (status < 0)
    refuse(text, std::string{"there is no such "} + wrong.at(static_cast<std::size_t>(-status - 1)));
  const double day = zero + modified;
  if (scale_.kind() == TimeScale::Kind::utc) {
    require_known_utc({day, 0.0}, what(text));
    day_ = utc_day(day);
  } else {
    day_ = {day, 0.0, 0.0, 0.0};
  }
  on_ = written.day;
}

Epoch EpochReader::read(std::string_view text) {
  std::string_view digits = text;
  const bool in_utc = scale_.kind() == TimeScale::Kind::utc;
  if (text.ends_with(end_)) {
    digits.remove_suffix(end_.size());
  } else if (in_utc && text.ends_with('Z')) {
    digits.remove_suffix(1);
  }
  const auto written = Written::of(digits);
  if (!written) refuse(text, "it is not written as 2022-04-14T10:22:11.874999");
  if (written->day != on_) begin_day(text, *written);
  if (written->hour > 23) refuse(text, "there is no such hour");
  if (written->minute > 59) refuse(text, "there is no such minute");
  const bool is_last = written->hour == 23 && written->minute == 59;
  if (written->second >= 60.0 + (is_last ? day_.step : 0.0)) refuse(text, "there is no such second");
  const double seconds = 60 * (60 * written->hour + written->minute) + written->second;
  const double fraction = seconds / day_.length();
  const Date tai = in_utc && fraction < 1.0 ? tai_of(day_, fraction)
                                            : tai_of(scale_, normalised(day_.day, fraction), what(text));
  return Epoch{JulianDate<scale::Tai>{tai.day, tai.fraction}};
}

// The last minute has what the day has more or less. What rounds up to the end of the day is the next one,
// but at the end of the year 9999, behind which there is no text that is read.
std::string calendar_text(const Date& date, double day_length, DayStyle style, int decimals) {
  if (decimals < 0 || decimals > 9) {
    throw BadInput("Epoch: asked for " + text(decimals) + " decimals; there can be 0 to 9");
  }
  const double unit = std::pow(10.0, decimals);
  const auto rounded = std::llround(date.fraction * day_length * unit);
  constexpr double rounding = 0.03;       // of the last digit, of which a day has 10^14
  constexpr double last_day = 5373483.5;  // 9999 December 31
  const bool is_end = static_cast<double>(rounded) > day_length * unit - rounding;
  const bool is_next = is_end && date.day != last_day;
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
  return day_text(is_next ? date.day + 1.0 : date.day, style) + buffer.data();
}

}  // namespace vectrix::detail
