#include <erfa.h>
#include <erfaextra.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/leap_seconds.hpp>

#include "../files/text_file.hpp"

namespace vectrix {
namespace {

using detail::text;

constexpr LeapSecond first_leap_second{1972, 1, 10};

std::string shown(const LeapSecond& leap) {
  return text(leap.year) + "-" + (leap.month < 10 ? "0" : "") + text(leap.month) + ", " +
         text(leap.tai_minus_utc) + " s";
}

std::vector<eraLEAPSECOND> table_of_erfa() {
  eraLEAPSECOND* rows = nullptr;
  const int count = eraGetLeapSeconds(&rows);
  return {rows, rows + count};
}

// The one that came with ERFA.
const std::vector<eraLEAPSECOND>& installed() {
  static const std::vector<eraLEAPSECOND> table = table_of_erfa();
  return table;
}

bool since_1972(const eraLEAPSECOND& row) {
  return row.iyear >= first_leap_second.year;
}
LeapSecond leap_second(const eraLEAPSECOND& row) {
  return {row.iyear, row.month, static_cast<int>(std::lround(row.delat))};
}

std::vector<LeapSecond> whole_seconds(const std::vector<eraLEAPSECOND>& table) {
  std::vector<LeapSecond> result;
  for (const auto& row : table) {
    if (since_1972(row)) result.push_back(leap_second(row));
  }
  return result;
}

int months(const LeapSecond& leap) {
  return 12 * leap.year + leap.month;
}

}  // namespace

std::vector<LeapSecond> leap_seconds() {
  return whole_seconds(table_of_erfa());
}

void use_leap_seconds(const std::vector<LeapSecond>& table) {
  const auto fail = [](const std::string& reason) { throw BadInput("use_leap_seconds: " + reason); };
  if (table.empty() || table.front() != first_leap_second)
    fail("the table does not begin with " + shown(first_leap_second));
  for (std::size_t i = 1; i < table.size(); ++i) {
    const LeapSecond &before = table[i - 1], &row = table[i];
    if (row.month < 1 || row.month > 12 || months(row) <= months(before) || row.year > 9999) {
      fail(shown(row) + " does not follow " + shown(before));
    }
    if (std::abs(row.tai_minus_utc - before.tai_minus_utc) != 1) {
      fail(shown(row) + " is not one second from " + shown(before));
    }
  }
  const auto known = whole_seconds(installed());
  const auto [ours, theirs] = std::mismatch(known.begin(), known.end(), table.begin(), table.end());
  if (ours != known.end()) {
    fail((theirs == table.end() ? "the table ends" : "there is " + shown(*theirs)) + " where ERFA has " +
         shown(*ours));
  }
  static std::vector<eraLEAPSECOND> rows;  // ERFA refers to it
  std::vector<eraLEAPSECOND> next;
  std::copy_if(installed().begin(), installed().end(), std::back_inserter(next),
               [](const eraLEAPSECOND& row) { return !since_1972(row); });
  for (const LeapSecond& row : table)
    next.push_back({row.year, row.month, static_cast<double>(row.tai_minus_utc)});
  rows.swap(next);
  eraSetLeapSeconds(rows.data(), static_cast<int>(rows.size()));
}

std::vector<LeapSecond> read_leap_seconds(const std::filesystem::path& file) {
  const auto content = detail::read_lines(file);
  if (!content) throw BadInput("leap seconds " + file.string() + ": cannot be read");
  std::vector<LeapSecond> table;
  std::size_t line_number = 0;
  for (const std::string& line : content->lines) {
    ++line_number;
    const auto fail = [&](std::size_t column, const std::string& reason) {
      throw BadInput("leap seconds " + file.string() + ", line " + text(line_number) + ", column " +
                     text(column + 1) + ": " + reason);
    };
    if (detail::trimmed(line).empty() || line.starts_with('#')) continue;
    std::array<double, 5> fields{};  // modified Julian day, day, month, year, TAI-UTC
    std::size_t at = 0;
    for (double& field : fields) {
      at = std::min(line.find_first_not_of(" \t", at), line.size());
      const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
      const auto number = detail::parse_number(std::string_view(line).substr(at, end - at));
      if (!number || *number != std::floor(*number) || std::abs(*number) > 1e6) {
        fail(at, "'" + line.substr(at, end - at) + "' is not a whole number");
      }
      field = *number;
      at = end;
    }
    if (!detail::trimmed(std::string_view(line).substr(at)).empty()) fail(at, "five numbers are expected");
    const LeapSecond row{static_cast<int>(fields[3]), static_cast<int>(fields[2]),
                         static_cast<int>(fields[4])};
    double day_zero = 0.0, day = 0.0;
    if (fields[1] != 1.0 || eraCal2jd(row.year, row.month, 1, &day_zero, &day) != 0 || day != fields[0]) {
      fail(0, "the modified Julian day " + text(fields[0]) + " is not the first of the month " +
                  text(row.year) + "-" + text(row.month));
    }
    // TAI-UTC cut to one digit is not one second from the row before.
    const bool has_end = content->whole || line_number < content->lines.size();
    if (!has_end && (table.empty() || std::abs(row.tai_minus_utc - table.back().tai_minus_utc) != 1))
      throw BadInput("leap seconds " + file.string() + ", line " + text(line_number) + ": " +
                     detail::truncated);
    table.push_back(row);
  }
  if (table.empty()) throw BadInput("leap seconds " + file.string() + ": there are no rows");
  return table;
}

}  // namespace vectrix
