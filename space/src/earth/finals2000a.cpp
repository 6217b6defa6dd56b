#include "finals2000a.hpp"
#include "erfa_rotation.hpp"

#include <erfa.h>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <vectrix/frames/errors.hpp>

#include "../files/text_file.hpp"

namespace vectrix::detail {
namespace {

struct Field {
  const char* name;
  std::size_t first, last;  // columns, from 1
};
constexpr Field mjd{"MJD", 8, 15};
constexpr std::array<Field, 5> parameter_fields{
    {{"x", 19, 27}, {"y", 38, 46}, {"UT1-UTC", 59, 68}, {"dX", 98, 106}, {"dY", 117, 125}}};

// The length of the day varies by a few milliseconds. UT1-TAI changes by more only at a leap second that the
// table lacks.
constexpr Quantity<si::time> largest_change_in_a_day = 0.01 * si::second;

// Arcseconds. No row of finals2000A, from 1973 to 2026, differs from the row before by more than 0.0054 in x
// and 0.0046 in y.
constexpr double largest_change_of_pole = 0.015;

// From 1979 to 1990 both kinds of offsets may be as small as the errors of that time. Of the square sums of
// any four neighbouring rows of finals2000A, shifted by what makes them those of finals.all, the ratio is
// 0.014 at least.
constexpr double clearly = 0.01;

// Milliarcseconds. No row of finals2000A, from 1973 to 2026, differs from the row before by more than 1.03;
// where rows of finals.all begin or end, the change is their distance from IAU 2006: 46 in 1973, 16 in 1990,
// 105 in 2022.
constexpr double largest_change_of_offsets = 3.0;

// dX, dY, and in the same columns of finals.all dPsi, dEps, milliarcseconds.
struct Offsets {
  double first, second;

  [[nodiscard]] double square() const { return first * first + second * second; }
  Offsets operator-(const Offsets& other) const { return {first - other.first, second - other.second}; }
};

// The dPsi, dEps of a pole that IAU 2006/2000A gives exactly: the error of IAU 1976/1980, -105 and -9 in
// 2022. To first order in the offsets, and in the precession since 2000: within some percent of themselves.
Offsets offsets_from_iau_1980(int day) {
  constexpr double mjd_zero = 2400000.5, milliarcseconds = 180.0 / std::numbers::pi * 3600e3;
  double x = 0.0, y = 0.0, pole_1980[3][3];
  eraXy06(mjd_zero, day, &x, &y);
  eraPnm80(mjd_zero, day, pole_1980);
  return {(x - pole_1980[2][0]) / std::sin(eraObl80(mjd_zero, day)) * milliarcseconds,
          (y - pole_1980[2][1]) * milliarcseconds};
}

class Finals2000AReader {
 public:
  Finals2000AReader(const std::filesystem::path& file, bool offsets_are_from_iau_2006)
      : file_(file), offsets_are_from_iau_2006_(offsets_are_from_iau_2006) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw BadInput("Earth orientation " + file_.string() + (line_ > 0 ? ", line " + text(line_) : "") + ": " +
                   reason);
  }
  [[noreturn]] void fail(const Field& field, const std::string& reason) const {
    fail(std::string{"columns "} + text(field.first) + "-" + text(field.last) + " (" + field.name +
         "): " + reason);
  }

  // The number in a field, or nothing if the field is blank.
  [[nodiscard]] std::optional<double> number(const std::string& line, const Field& field) const {
    const auto written =
        line.size() < field.first
            ? std::string_view{}
            : trimmed(std::string_view{line}.substr(field.first - 1, field.last - field.first + 1));
    if (written.empty()) return std::nullopt;
    const auto value = parse_number(written);
    if (!value || !std::isfinite(*value)) {
      fail(field,
           std::string{"'"}.append(written) + (value ? "' is not a finite number" : "' is not a number"));
    }
    return value;
  }

  // Without a line end, a line is whole if it has all columns that are read.
  void row(const std::string& line, bool has_end) {
    ++line_;
    if (line.starts_with('#')) return;
    if (!has_end && line.size() < parameter_fields.back().last) fail(truncated);
    const auto day = number(line, mjd);
    if (!day) fail(mjd, "the field is blank");
    if (*day != std::floor(*day) || std::abs(*day) > 1e6) fail(mjd, text(*day) + " is not a whole day");
    if (last_day_ && *day != *last_day_ + 1.0) {
      fail(mjd, std::string{"the day "} + text(*day) + " follows " + text(*last_day_) +
                    "; rows must be a day apart");
    }
    last_day_ = day;

    std::array<double, parameter_fields.size()> found{};
    const Field* blank = nullptr;
    for (std::size_t i = 0; i < parameter_fields.size(); ++i) {
      const auto value = number(line, parameter_fields[i]);
      if (!value && blank == nullptr) blank = &parameter_fields[i];
      if (value) found[i] = *value;
    }
    if (blank != nullptr) {
      if (incomplete_line_ == 0) {
        incomplete_line_ = line_;
        incomplete_field_ = blank;
      }
    } else if (incomplete_line_ > 0) {
      line_ = incomplete_line_;
      fail(*incomplete_field_, "the field is blank, but a complete row follows");
    } else {
      require_possible(found);
      add(static_cast<int>(*day), found);
    }
  }

  // 999.99 stands for a missing value in many a series.
  void require_possible(const std::array<double, parameter_fields.size()>& found) const {
    constexpr double offset = largest_pole_offset;
    constexpr std::array largest{offset, offset, 1.0, 1e3 * offset, 1e3 * offset};
    constexpr std::array units{"arcsec", "arcsec", "s", "milliarcsec", "milliarcsec"};
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (std::abs(found[i]) > largest[i]) {
        fail(parameter_fields[i],
             text(found[i]) + " " + units[i] + " is more than " + text(largest[i]) + " " + units[i]);
      }
    }
  }

  [[nodiscard]] Epoch midnight(int day) const {
    try {
      return Epoch::from_utc_mjd(day);
    } catch (const BadInput& error) {
      fail(mjd, error.what());
    }
  }

  void require_small_change_of_pole(const std::array<double, parameter_fields.size()>& found) const {
    for (const std::size_t i : {0U, 1U}) {
      const double change = 1e-6 * std::round(1e6 * (found[i] - pole_before_[i]));  // as it is written
      if (std::abs(change) > largest_change_of_pole) {
        fail(parameter_fields[i], text(found[i]) + " arcsec changes by " + text(change) +
                                      " from the row before; the pole moves by at most " +
                                      text(largest_change_of_pole) + " in a day");
      }
    }
  }

  void add(int day, const std::array<double, parameter_fields.size()>& found) {
    const Epoch epoch = midnight(day);
    const auto arcseconds = [](double angle) { return convert<si::angle>(angle * si::arcsecond); };
    const auto ut1_minus_tai = found[2] * si::second - epoch.tai_minus_utc();
    if (!rows_.empty()) {
      require_small_change_of_pole(found);
      const auto change = ut1_minus_tai - rows_.back().ut1_minus_tai;
      if (std::abs(change.value()) > largest_change_in_a_day.value()) {
        fail(parameter_fields[2], std::string{"UT1-TAI changes by "} + text(change.value()) +
                                      " s in a day; is there a leap second missing?");
      }
    }
    pole_before_ = {found[0], found[1]};
    days_.push_back({day, line_, {found[3], found[4]}});
    epochs_.push_back(epoch);
    EarthOrientationParameters row{};
    row.pole_x = arcseconds(found[0]);
    row.pole_y = arcseconds(found[1]);
    row.ut1_minus_tai = ut1_minus_tai;
    row.dX = arcseconds(1e-3 * found[3]);
    row.dY = arcseconds(1e-3 * found[4]);
    rows_.push_back(row);
  }

  std::pair<std::vector<Epoch>, std::vector<EarthOrientationParameters>> result() {
    if (!rows_.empty()) require_offsets_from_iau_2006();
    constexpr std::size_t fewest = 4;  // for a cubic spline
    if (rows_.size() >= fewest) return {std::move(epochs_), std::move(rows_)};
    line_ = incomplete_line_;
    const std::string few = text(rows_.size()) + " complete rows; there must be four";
    if (incomplete_field_ != nullptr) fail(*incomplete_field_, "the field is blank after " + few);
    fail(few);
  }

 private:
  struct Day {
    int mjd;
    std::size_t line;
    Offsets offsets;
  };

  // A row alone. Of the rows of finals2000A the ratio is 0.033 at least.
  [[nodiscard]] static bool is_from_1980(const Day& day) {
    return (day.offsets - offsets_from_iau_1980(day.mjd)).square() < clearly * day.offsets.square();
  }
  [[noreturn]] void fail_at(const Day& day, const std::string& reason) {
    line_ = day.line;
    fail(parameter_fields[3],
         text(day.offsets.first) + " and " + text(day.offsets.second) + " milliarcseconds " + reason);
  }
  [[noreturn]] void fail_from_1980(const Day& day) {
    fail_at(day,
            "are offsets of the pole from IAU 1980, as finals.all has them in these columns, not from IAU "
            "2006/2000A; read finals2000A");
  }

  // Fails where one series ends and another begins.
  void require_one_series() {
    for (std::size_t i = 1; i < days_.size(); ++i) {
      const Day &before = days_[i - 1], &day = days_[i];
      const double change = std::sqrt((day.offsets - before.offsets).square());
      if (change <= largest_change_of_offsets) continue;
      if (is_from_1980(before)) fail_from_1980(days_.front());
      if (is_from_1980(day)) fail_from_1980(day);
      fail_at(day, "differ by " + text(change) +
                       " from the row before; those of one series change by at most " +
                       text(largest_change_of_offsets) + " in a day");
    }
  }

  // Fails unless the offsets are clearly nearer to zero than to those from IAU 1980; if they are about as
  // near to both, unless the caller has said what they are. Some rows of the file tell.
  void require_offsets_from_iau_2006() {
    require_one_series();
    constexpr std::size_t examined = 64;
    const std::size_t step = 1 + days_.size() / examined;
    double from_2006 = 0.0, from_1980 = 0.0;
    const Day* largest = &days_.front();
    for (std::size_t i = 0; i < days_.size(); i += step) {
      from_2006 += days_[i].offsets.square();
      from_1980 += (days_[i].offsets - offsets_from_iau_1980(days_[i].mjd)).square();
      if (days_[i].offsets.square() > largest->offsets.square()) largest = &days_[i];
    }
    if (from_2006 <= clearly * from_1980) return;
    if (clearly * from_2006 >= from_1980)
      fail_from_1980(is_from_1980(days_.front()) ? days_.front() : *largest);
    if (offsets_are_from_iau_2006_) return;
    fail_at(
        *largest,
        "may be offsets of the pole from IAU 2006/2000A, or from IAU 1980, as finals.all has them in these "
        "columns: these rows do not tell; if the file is finals2000A, say offsets_from_iau_2006");
  }

  const std::filesystem::path& file_;
  bool offsets_are_from_iau_2006_;
  std::size_t line_ = 0;
  std::optional<double> last_day_;
  std::size_t incomplete_line_ = 0;
  const Field* incomplete_field_ = nullptr;
  std::array<double, 2> pole_before_{};
  std::vector<Day> days_;
  std::vector<Epoch> epochs_;
  std::vector<EarthOrientationParameters> rows_;
};

}  // namespace

std::pair<std::vector<Epoch>, std::vector<EarthOrientationParameters>> read_finals2000A(
    const std::filesystem::path& file, bool offsets_are_from_iau_2006) {
  Finals2000AReader reader{file, offsets_are_from_iau_2006};
  const auto content = read_lines(file);
  if (!content) reader.fail("cannot be read");
  for (std::size_t i = 0; i < content->lines.size(); ++i) {
    reader.row(content->lines[i], content->whole || i + 1 < content->lines.size());
  }
  return reader.result();
}

}  // namespace vectrix::detail
